// Robots in Python, played by MicroPython without a page around it.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { wasmFile } from '../../build/python';
import { startRobot } from '../../src/write/python/robot';
import type { FromWorker } from '../../src/write/runtime';

const wasm = readFileSync(wasmFile);

/** What a robot says to the briefing of a maze of that size and to those readings. */
export async function talk(
  program: string,
  readings: number[][] = [],
  size = 12,
  seed = 1,
): Promise<{ lines: string[]; printed: string; failed: { message: string; line: number | null } | null }> {
  const said: FromWorker[] = [];
  const robot = await startRobot(wasm, program, (message) => said.push(message));
  const briefing = ['labmouse 1', `size ${size} ${size}`, 'start 0 0 north', 'stride 3', 'budget 1000', `seed ${seed}`];
  for (const line of [...briefing, 'begin', ...readings.map((reading) => `sense ${reading.join(' ')}`)])
    robot.hear(line);
  return {
    lines: said.flatMap((one) => (one.kind === 'reply' ? one.lines : [])),
    printed: said.map((one) => (one.kind === 'print' ? one.text : '')).join(''),
    failed: said.find((one) => one.kind === 'failed') ?? null,
  };
}

/** A starting point of the page. */
export const template = (name: string) =>
  readFileSync(fileURLToPath(new URL(`../../../../../templates/robots/${name}.py`, import.meta.url)), 'utf8');

/** A robot that runs that code when it is made, and answers with that expression. */
export const robot = (code: string, answer = '(0, 1)') =>
  `class Robot(object):\n    def __init__(self, maze_dim):\n${code.replace(/^/gm, '        ')}\n` +
  `    def next_move(self, sensors):\n        return ${answer}\n`;
