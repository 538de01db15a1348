// The starting points: those that flood solve all mazes; those in Python do in the page, answer for answer, what they do on
// the command line under CPython.
import { execFile, execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { afterAll, describe, expect, it } from 'vitest';
import type { RaceResults } from '../../src/core/types';
import { javascript } from '../../src/write/javascript/language';
import { python } from '../../src/write/python/language';
import { talk, template } from './talk';

const program = process.env.LABMOUSE_PROGRAM ?? '';
const mazeFolder = resolve(__dirname, '../../../../../mazes');
const folder = mkdtempSync(join(tmpdir(), 'labmouse-robots-'));
afterAll(() => rmSync(folder, { recursive: true }));

interface Step {
  reading: number[];
  action: 'reset' | [number, number];
}

/** The steps of a robot's contest on the command line. */
function contest(robot: string, maze: string, seed: number) {
  writeFileSync(join(folder, 'robot.py'), robot);
  const words = ['run', 'capstone:robot.py', maze, '--seed', `${seed}`, '--record', 'record.jsonl'];
  execFileSync(program, words, { cwd: folder });
  const lines = readFileSync(join(folder, 'record.jsonl'), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  const steps = lines.filter((line) => 'reading' in line) as Step[];
  return { steps, size: (lines[0].maze.drawing.length - 1) / 2 };
}

/** Throws its dice in most of the ways that robots do. */
const dicer = `import random
class Robot(object):
    def __init__(self, maze_dim):
        self.own = random.Random(5)
        self.turns = [-90, 0, 90]
    def next_move(self, sensors):
        random.shuffle(self.turns)
        ways = [turn for turn in self.turns if random.random() < 0.8] or [random.choice(self.turns)]
        return ways[self.own.randrange(len(ways))], random.randint(0, 3) + len(random.sample(range(40), 3)) - 3
`;

/** The goal of parallel-8 is not in the centre. Without LABMOUSE_PROOF the first two are enough. */
const mazesOfRobots = (
  [
    ['parallel-8', 1],
    ['capstone-1', 1],
    ['onion-12', 2],
  ] as const
).slice(0, process.env.LABMOUSE_PROOF ? 3 : 2);
/** Of the robots that never arrive, so many steps are enough. */
const most = 150;

/** All mazes but the large ones, which take longer; without LABMOUSE_PROOF every fourth. */
const small = readdirSync(mazeFolder)
  .filter((name) => name.endsWith('.txt') && !/contest-(half|1[48]|2\d)-|-30/.test(name))
  .filter((_, index) => process.env.LABMOUSE_PROOF || index % 4 === 0)
  .map((name) => join(mazeFolder, name));

describe.each([javascript, python])('what one begins with in $name', ({ templates }) => {
  it.each(templates)('$name says briefly what it does', ({ text }) => {
    const [description] = /^(\/\/.*\n)+|^"""[^"]*"""/.exec(text)!;
    expect(description.length).toBeGreaterThan(20);
    expect(description.length).toBeLessThan(240);
  });
});

describe.skipIf(!existsSync(program))('robots in the page and on the command line', () => {
  const robots: [name: string, text: string][] = [
    ...['wall_follower', 'flood_fill', 'flood_and_return', 'empty'].map((name): [string, string] => [
      name,
      template(name),
    ]),
    ['a robot with dice', dicer],
  ];
  it.each(robots)('%s answers the same', async (_, text) => {
    for (const [maze, seed] of mazesOfRobots) {
      const { steps: all, size } = contest(text, maze, seed);
      const steps = all.slice(0, most);
      const { lines, failed } = await talk(
        text,
        steps.map(({ reading }) => reading),
        size,
        seed,
      );
      expect(failed).toBeNull();
      const answers = steps.map(({ action }) => (action === 'reset' ? action : `move ${action.join(' ')}`));
      expect(lines).toEqual(['labmouse 1', ...answers]);
    }
  });
  it.each([
    ['Flood fill', python],
    ['Flood and return', python],
    ['Flood fill', javascript],
    ['Flood and return', javascript],
  ])('%s solves the mazes', async (name, { commandLine, fileName, templates }) => {
    writeFileSync(join(folder, fileName), templates.find((one) => one.name === name)!.text);
    const words = ['race', '--mice', commandLine, '--format', 'json', '--mazes', ...small];
    const { stdout } = await promisify(execFile)(program, words, { cwd: folder, maxBuffer: 1 << 28 });
    const [{ mazes, mice }] = (JSON.parse(stdout) as RaceResults).groups;
    expect([mice[0].finished, mazes.length]).toEqual([small.length, small.length]);
  });
});
