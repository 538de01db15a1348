// The view Write without a browser: programs as scripts, and as links.
import { readFileSync } from 'node:fs';
import { runInNewContext } from 'node:vm';
import { describe, expect, test, vi } from 'vitest';
import { holdContest } from '../../src/write/contest';
import { linkOf, longestProgram, readLink, readWork } from '../../src/write/keeping';
import { languages } from '../../src/write/languages';
import { linesBefore, withoutImports, workerSource } from '../../src/write/javascript/source';
import { nameBefore } from '../../src/write/racing';
import type { ToWorker } from '../../src/write/runtime';
import type { Said } from '../../src/write/sandbox/cage';
import { createPatience, type Patience } from '../../src/write/sandbox/patience';
import type { Core } from '../../src/core/client';
import type { MazeData } from '../../src/core/types';

const [javascript] = languages;
const work = { language: javascript, name: 'mine', text: 'const a = "ä€😀";\n'.repeat(50) };

test('a program comes back from its link', async () => {
  const link = await linkOf(work);
  expect(link).toMatch(/^[\w-]+$/);
  expect(link.length).toBeLessThan(200);
  expect(await readLink(link)).toEqual(work);
});

test('a link has only what links may have, whatever is in it', async () => {
  // So many that both signs of base64 that mean something else in links come up.
  for (let i = 0; i < 40; ++i) {
    const other = { ...work, text: `${i * 7919} ${'~?>'.repeat(i)}` };
    const link = await linkOf(other);
    expect(link).toMatch(/^[\w-]+$/);
    expect(await readLink(link)).toEqual(other);
  }
});

test('what is no link is none', async () => {
  const link = await linkOf(work);
  for (const bad of ['', 'x', 'AAAA', '%', link.slice(0, -9), `${link.slice(0, 9)}A${link.slice(10)}`])
    expect(await readLink(bad)).toBeNull();
  expect(await readLink(await linkOf({ ...work, text: ' '.repeat(20 * longestProgram) }))).toBeNull();
  for (const bad of [
    '',
    '[]',
    'null',
    '{"language":"cobol","name":"","text":""}',
    '{"language":"javascript","name":1,"text":""}',
    JSON.stringify({ language: 'javascript', name: '', text: ' '.repeat(longestProgram + 1) }),
  ])
    expect(readWork(bad)).toBeNull();
});

test('imports become what a script can say, and no line moves', () => {
  const program = `import readline from 'node:readline';\nimport * as os from "os"\nimport { a as b, c } from 'm';\nimport 'x';\nimportant('y');`;
  expect(withoutImports(program)).toBe(
    `const readline = require("node:readline");\nconst os = require("os");\nconst { a: b, c } = require("m");\nrequire("x");\nimportant('y');`,
  );
});

test('a program begins in its line', () => {
  expect(workerSource('first();\nsecond();').split('\n')[linesBefore]).toBe('first();');
});

/** Runs a script as a worker would, and returns what it said. */
function worker(program: string) {
  const said: unknown[] = [];
  const self: Record<string, unknown> = {
    postMessage: (message: unknown) => said.push(message),
    close() {},
    addEventListener() {},
  };
  const tasks = { queueMicrotask, setTimeout, performance };
  runInNewContext(workerSource(program), Object.assign(self, tasks, { self }));
  const tell = async (data: ToWorker) => {
    (self.onmessage as (event: { data: ToWorker }) => void)({ data });
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { said, tell };
}

describe('a program finds what node has', () => {
  const answering = {
    'readline with events': `require('readline').createInterface({input: process.stdin}).on('line', (line) => console.log('got', line))`,
    'readline with a loop': `import readline from 'node:readline';\nfor await (const line of readline.createInterface({input: process.stdin})) console.log('got', line);`,
    'data of standard input': `process.stdin.setEncoding('utf8').on('data', (text) => process.stdout.write('got ' + text))`,
    'standard input with a loop': `(async () => { for await (const text of process.stdin) process.stdout.write('got ' + text); })()`,
  };
  test.each(Object.entries(answering))('%s', async (_, program) => {
    const { said, tell } = worker(program);
    await tell({ kind: 'start', program });
    await tell({ kind: 'hear', line: 'a' });
    await tell({ kind: 'hear', line: 'b' });
    const lines = said.flatMap((one) => (one as { lines?: string[] }).lines ?? []);
    expect(lines).toEqual(['got a', 'got b']);
  });

  test('two lines of one turn go out together, after what was printed', async () => {
    const { said, tell } = worker(
      `console.error('note', [1, 'x'], { a: null }); console.log(1); process.stdout.write('2\\n3');`,
    );
    await tell({ kind: 'start', program: '' });
    expect(said).toEqual([
      { kind: 'print', text: "note [ 1, 'x' ] { a: null }\n" },
      { kind: 'ready' },
      { kind: 'reply', lines: ['1', '2'], rest: '3' },
    ]);
  });
});

/** A core and a program that say what they are told to, and what the core heard. */
async function contest(said: Said[]) {
  const heard: unknown[] = [];
  const lines = (ended: boolean) => ({ contest: 1, lines: ['sense 0 0 0'], ended, steps: heard.length });
  const core = {
    call: async (name: string, request: Record<string, unknown>) => {
      if (name !== 'program_hear') return name === 'program_begin' ? lines(false) : {};
      heard.push(request);
      return lines('end' in request);
    },
  } as unknown as Core;
  const patiences: Patience[] = [];
  const next = async (patience: Patience) => (patiences.push(patience), said.shift() ?? null);
  const session = { say() {}, next, end() {} };
  const cage = { start: async () => session, close() {} };
  const entry = { language: javascript, program: '', name: '', maze: {} as MazeData, seed: 1 };
  const held = await holdContest(core, cage, entry);
  return { held, heard, waited: patiences.map((one) => patiences.indexOf(one)) };
}

test('a program that says nothing more has hung, and what it had printed is told', async () => {
  const { heard, held } = await contest([
    { kind: 'ready' },
    { kind: 'print', text: 'a\n' },
    { kind: 'reply', lines: [], rest: 'mo' },
  ]);
  expect(heard).toEqual([{ contest: 1, output: 'mo', printed: 'a\n', end: { kind: 'silent', seconds: 2 } }]);
  expect(held!.prints).toEqual([{ frame: 0, text: 'a\n' }]);
});

test('a program has ten seconds to begin, and two for each answer, however much it prints; what it printed is reported once', async () => {
  const { heard, waited } = await contest([
    { kind: 'print', text: 'a\n' },
    { kind: 'ready' },
    { kind: 'print', text: 'b\n' },
    { kind: 'reply', lines: ['one'] },
    { kind: 'reply', lines: ['two'] },
    { kind: 'exited', code: 0 },
  ]);
  expect(waited).toEqual([0, 0, 2, 2, 4, 5]);
  expect(heard).toMatchObject([{ printed: 'a\nb\n' }, { printed: '' }, { printed: '' }]);
  expect((await contest([])).heard).toMatchObject([{ end: { kind: 'silent', seconds: 10 } }]);
});

/** Milliseconds until two seconds of patience are over on a machine that takes so many for each piece of it. */
async function patienceWhereAPieceTakes(each: number) {
  vi.useFakeTimers();
  const patience = createPatience(2000);
  const began = performance.now();
  while (patience.isLeft()) {
    const piece = patience.piece(() => undefined);
    vi.advanceTimersByTime(each);
    await piece;
  }
  const took = performance.now() - began;
  vi.useRealTimers();
  return took;
}

test('time in which the page does not run counts little, and five times as long is enough', async () => {
  expect(await patienceWhereAPieceTakes(50)).toBe(2000);
  expect(await patienceWhereAPieceTakes(100)).toBe(4000);
  expect(await patienceWhereAPieceTakes(1000)).toBe(10_000);
});

/** What the script of the frame sends to the page when its worker says these things, one after the other. */
function framed(said: unknown[]) {
  let begin: (event: unknown) => void = () => {};
  const sent: unknown[] = [];
  const workers: { onmessage: ((event: { data: unknown }) => void) | null; terminated: boolean }[] = [];
  class FakeWorker {
    onmessage = null;
    terminated = false;
    constructor() {
      workers.push(this);
    }
    terminate() {
      this.terminated = true;
    }
  }
  const script = readFileSync(new URL('../../src/write/sandbox/frame.js', import.meta.url), 'utf8');
  runInNewContext(script, {
    addEventListener: (_: string, heard: typeof begin) => (begin = heard),
    Worker: FakeWorker,
    Blob,
    URL: { createObjectURL: () => '', revokeObjectURL() {} },
  });
  begin({ data: { source: '', linesBefore: 0 }, ports: [{ postMessage: (words: unknown) => sent.push(words) }] });
  for (const data of said) workers[0].onmessage?.({ data });
  return { sent, terminated: workers[0].terminated };
}

test('a program that writes too much is ended, whether it means anything or not', () => {
  const print = (text: string) => ({ kind: 'print', text });
  for (const [count, words] of [
    [5000, print('a')],
    [5000, null],
    [10, print('a'.repeat(1e5))],
  ] as const) {
    const much = framed(Array<unknown>(count).fill(words));
    expect(much.terminated).toBe(false);
    const tooMuch = framed(Array<unknown>(count + 10).fill(words));
    expect(tooMuch.terminated).toBe(true);
    expect(tooMuch.sent.at(-1)).toEqual({ kind: 'flooded' });
    expect(tooMuch.sent).toHaveLength(much.sent.length + 1);
  }
});

test('the version before is told from the one of now, within the longest name', () => {
  expect(nameBefore('first', 'second')).toBe('first');
  expect(nameBefore('mine', 'mine')).toBe('mine-before');
  expect(nameBefore('m'.repeat(40), 'm'.repeat(40))).toHaveLength(40);
});

test('what is no Unicode does not reach the core', async () => {
  const { heard } = await contest([
    { kind: 'reply', lines: ['a\ud800'] },
    { kind: 'failed', message: 'Uncaught \udc00', line: 3 },
  ]);
  expect(heard).toMatchObject([{ output: 'a\ufffd\n' }, { end: { kind: 'failed', message: '\ufffd', line: 3 } }]);
});
