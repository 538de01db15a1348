// The core as WebAssembly under node: every call answers in its shape, and a bad request is told of in words.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { beforeAll, describe, expect, test } from 'vitest';
import { startModule, type Call } from '../../src/core/module';
import type { CallName, Calls, Failure, MazeData, PackedRecord, Play } from '../../src/core/types';

const file = process.env.LABMOUSE_CORE ?? resolve(__dirname, '../../../../../build/web/labmouse_core.wasm');

const program = process.env.LABMOUSE_PROGRAM;

/** The signature of the native program; nothing where there is none. The stage `portable` of `.ci/run` compares them, too. */
const signature =
  process.env.LABMOUSE_PROOF && program && existsSync(program)
    ? execFileSync(program, ['bench', '--signature'], { encoding: 'utf8' }).trim()
    : '';

describe.skipIf(!existsSync(file))('the core', () => {
  let core: Call;
  let maze: MazeData;
  let play: Play;
  let record: string;

  function answer<Name extends CallName>(
    name: Name,
    request: Calls[Name]['request'],
    bytes?: Uint8Array,
  ): Calls[Name]['answer'] {
    const reply = core(name, request, bytes);
    expect(reply.failure).toBeUndefined();
    return reply.answer as Calls[Name]['answer'];
  }
  function failure(name: string, request: unknown, bytes?: Uint8Array): Failure {
    const reply = core(name, request, bytes);
    expect(reply.answer).toBeUndefined();
    return reply.failure!;
  }
  const text = (content: string) => new TextEncoder().encode(content);

  beforeAll(async () => {
    core = await startModule(await WebAssembly.compile(readFileSync(file)));
    maze = answer('builtin_maze', { name: 'contest-01' }).maze;
    ({ play, record } = answer('contest', { mouse: 'ariadne', maze, seed: 1 }));
  });

  test('tells what it brings', () => {
    const about = answer('about', {});
    expect(about.mice.map((mouse) => mouse.name)).toContain('ariadne');
    expect(about.mazes.map((each) => each.name)).toContain('contest-01');
    expect(about.formats).toHaveLength(11);
    expect(about.generators.length).toBeGreaterThan(5);
    expect(about.rules).toEqual({ budget: 1000, search_factor: 30, stride: 3, failure_score: 100 });
  });

  test.skipIf(!signature)(
    'has the signature of the native program',
    () => {
      expect(answer('signature', {}).signature).toBe(signature);
    },
    60_000,
  ); // seconds where the machine has others to serve

  test('measures distance fields', () => {
    const { distance_ns } = answer('speed', {});
    expect(Object.keys(distance_ns)).toEqual(['16', '32', '64']);
    for (const ns of Object.values(distance_ns))
      expect(Object.keys(ns)).toEqual(['rows', 'portable_rows', 'queue', 'plain']);
  });

  test('makes and inspects mazes', () => {
    const made = answer('make_maze', { generator: 'contest', width: 16, height: 16, seed: 7, loops: 0 }).maze;
    expect(made.walls).toHaveLength(256);
    const found = answer('inspect', { maze: made });
    expect(found.contest_rules.filter((rule) => !rule.passed)).toEqual([]);
    expect(found.distances).toHaveLength(256);
    expect(found.route).toHaveLength(found.optimum! + 1);
  });

  test('plays a contest frame by frame', () => {
    const frames = play.clock.length;
    expect(play.finished).toBe(true);
    expect(frames).toBe(play.search_steps + play.speed_steps + 1);
    for (const list of [play.x, play.y, play.heading, play.run]) expect(list).toHaveLength(frames);
    for (const list of [play.action, play.blocked, play.left, play.entered]) expect(list).toHaveLength(frames - 1);
    expect(play.known).toHaveLength(2 * maze.walls.length);
    expect(play.run[play.reset_frame!]).toBe(1);
    expect(play.reasons.length).toBeGreaterThan(0);
  });

  test('opens what it wrote', () => {
    const opened = answer('open', { name: 'walk.jsonl' }, text(record));
    expect(opened).toEqual({ kind: 'record', play });
    for (const { name: format } of answer('about', {}).formats) {
      const said = answer('write_maze', { maze, format });
      const content = said.text === undefined ? Uint8Array.from(said.bytes!) : text(said.text);
      expect(answer('open', { name: maze.name }, content)).toEqual({ kind: 'maze', maze, notes: [] });
    }
  });

  test('holds races and reads their results', () => {
    const { results } = answer('race', { mice: ['flood', 'certify'], mazes: [maze], seed: 1, runs: 1 });
    expect(results.groups[0].mice.map((mouse) => mouse.finished)).toEqual([1, 1]);
    expect(results.processor).toBe('WebAssembly');
    expect(answer('open', { name: 'race.json' }, text(JSON.stringify(results)))).toEqual({ kind: 'results', results });
  });

  test('unpacks records', () => {
    const packed: PackedRecord = { mouse: 'stranger', maze: maze.name, actions: 'k!gave up;', outcome: 'forfeit' };
    const unpacked = answer('unpack', { record: packed, maze });
    expect(unpacked.play.outcome).toBe('forfeit: gave up');
    expect(unpacked.record.split('\n')).toHaveLength(5);
  });

  test('holds mazes in links', () => {
    const { link } = answer('link', { maze });
    expect(link).toMatch(/^[\w.-]+$/);
    expect(answer('read_link', { link }).maze).toEqual(maze);
  });

  test('compares scores', () => {
    const said = answer('compare', { differences: [-1, -2, 0, 0.5] });
    expect(said).toMatchObject({ count: 4, below: 2, equal: 1, above: 1 });
    expect(said.interval[0]).toBeLessThan(said.mean);
  });

  test('knows what a mouse believed', () => {
    const frames = play.clock.length;
    const { bytes } = answer('beliefs', { maze, known: play.known, frames, stride: 3 });
    const steps = new Uint16Array(bytes.buffer);
    expect(steps).toHaveLength(frames * maze.walls.length);
    // No belief is longer than the truth.
    const cells = maze.walls.length;
    for (let i = 0; i < steps.length; ++i)
      if (play.distances[i % cells] >= 0) expect(steps[i]).toBeLessThanOrEqual(play.distances[i % cells]);
  });

  test('draws pictures', () => {
    expect(answer('picture', { maze }).svg).toContain('<svg');
    expect(answer('picture', {}, text(record)).svg).toContain('ariadne');
  });

  test('says what is wrong with a request or a file, and lives on', () => {
    expect(failure('contest', { mouse: 'flod', maze, seed: 1 }).error).toContain("did you mean 'flood'?");
    expect(failure('contest', { mouse: 'program:ls', maze, seed: 1 }).error).toContain('which the page cannot start');
    expect(failure('contest', { mouse: 'ariadne:prior=mine', maze, seed: 1 }).error).toContain(
      'which the page cannot read',
    );
    expect(failure('inspect', { maze: { ...maze, walls: [] } }).error).toContain('0 cells');
    expect(failure('inspect', null).error).toBe('the request is not a JSON object');
    expect(failure('open', { name: 'x' }, text('o---o\n|   x\no---o\n')).problems[0]).toMatchObject({
      line: 2,
      column: 5,
    });
    expect(failure('open', { name: 'x' }, text('{"mice": [\n1,}')).problems[0]).toMatchObject({ line: 2, column: 3 });
    expect(failure('read_link', { link: 'x' }).problems).toHaveLength(1);
    expect(answer('builtin_maze', { name: 'contest-01' }).maze).toEqual(maze);
  });
});
