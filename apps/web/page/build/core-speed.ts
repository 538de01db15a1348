// How fast the core is as WebAssembly under node, beside the native program, in one run.
// Usage: npx vite-node build/core-speed.ts CORE.wasm PROGRAM
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { startModule } from '../src/core/module';
import type { Calls, CallName, MazeData } from '../src/core/types';
import { pack } from './pack';

const [file, program] = process.argv.slice(2);
if (!file || !program) throw new Error('usage: npx vite-node build/core-speed.ts CORE.wasm PROGRAM');
const wasm = readFileSync(file);
const core = await startModule(await WebAssembly.compile(wasm));

function ask<Name extends CallName>(name: Name, request: Calls[Name]['request']): Calls[Name]['answer'] {
  const { answer, failure } = core(name, request);
  if (!answer) throw new Error(failure?.error);
  return answer as Calls[Name]['answer'];
}

function milliseconds(work: () => void): number {
  const begin = performance.now();
  work();
  return performance.now() - begin;
}

const native: Record<string, Record<string, number>> = JSON.parse(
  execFileSync(program, ['bench', '--format', 'json'], { encoding: 'utf8' }),
).distance_ns;
// Once to let node compile it well.
ask('speed', {});
const own = ask('speed', {}).distance_ns;
console.log('distance field, median ns\n side    native   WebAssembly   ratio (at most 3)');
for (const [side, { rows }] of Object.entries(own)) {
  const columns = [side.padStart(5), native[side].rows.toFixed(0).padStart(10), rows.toFixed(0).padStart(14)];
  console.log(columns.join(''), (rows / native[side].rows).toFixed(2).padStart(7));
}

const mazes: MazeData[] = [];
for (let seed = 1; seed <= 24; ++seed)
  mazes.push(ask('make_maze', { generator: 'contest', width: 16, height: 16, seed, loops: 0 }).maze);
const race = milliseconds(() => ask('race', { mice: ['certify'], mazes, seed: 1, runs: 1 }));
console.log(`certify in 24 mazes of 16x16: ${race.toFixed(0)} ms (at most 2000)`);
console.log(`size: ${wasm.length} bytes, packed as text ${(await pack(wasm)).length}`);
