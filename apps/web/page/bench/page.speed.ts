// How quick the page is in Chromium, beside the figures of stated.json: prints a table, asserts nothing. `npm run speed`, with
// mazes in ../shared for the report. The tests hold the page to three times these figures.
import { readFileSync, readdirSync, statSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { afterAll, test } from 'vitest';
import type { Core } from '../src/core/client';
import type { Meter } from '../src/player/meter';
import { builtPage, drop, manyMazes, native, open, replayed, temporary } from '../tests/end-to-end/harness';
import { firstRun, frontDoor, median, memory, playing, twoMice, type Figure } from './measures';
import { size } from './size';
import stated from './stated.json';

declare global {
  interface Window {
    labmouse: Core;
  }
}

const rows: { what: string; measured: string; bar: string }[] = [];
const note = (what: string, measured: string, bar: string) => rows.push({ what, measured, bar });
afterAll(() => console.table(Object.fromEntries(rows.map(({ what, ...rest }) => [what, rest]))));

const megabytes = (file: string) => `${(statSync(file).size / 1e6).toFixed(2)} MB`;
const seconds = (list: number[]) =>
  `${(median(list) / 1000).toFixed(2)} s (${list.map((one) => (one / 1000).toFixed(2)).join(', ')})`;

/** One of the stated figures: the middle of what was measured, all of it, and what is stated. */
function compare(figure: Figure, ...list: number[]) {
  const { what, unit, stated: bar } = stated[figure];
  const all = list.length > 1 ? ` (${list.map((one) => one.toFixed(2)).join(', ')})` : '';
  note(what, `${median(list).toFixed(2)} ${unit}${all}`, `${bar} ${unit}`);
}

test('the page', () => compare('size', size()));

test('the first that is seen', async () => {
  const [doors, runs] = [[], []] as { paint: number; wall: number; processor: number }[][];
  for (let i = 0; i < 5; ++i) doors.push(await frontDoor());
  for (let i = 0; i < 5; ++i) runs.push(await firstRun());
  compare('paint', ...doors.map(({ paint }) => paint));
  compare('movement', ...doors.map(({ wall }) => wall));
  compare('movement, processor', ...doors.map(({ processor }) => processor));
  compare('run', ...runs.map(({ wall }) => wall));
  compare('run, processor', ...runs.map(({ processor }) => processor));
});

test('a replay of two mice in 64 by 64 cells', { timeout: 300_000 }, async () => {
  const page = await twoMice(64);
  const { rate, cost } = await playing(page, '8×', 5);
  compare('rate', rate);
  compare('cost', cost);
  await playing(page, '64×', 60);
  compare('memory', await memory(page));
});

test('certify on contest mazes', async () => {
  const page = await open('#race');
  const times = await page.evaluate(async () => {
    const { mazes } = await window.labmouse.call('about', {});
    const names = mazes.filter(({ name, width, height }) => /contest/.test(name) && width === 16 && height === 16);
    const chosen = [];
    for (const { name } of names) chosen.push((await window.labmouse.call('builtin_maze', { name })).maze);
    for (let seed = 1; chosen.length < 24; ++seed) {
      const order = { generator: 'contest', width: 16, height: 16, seed, loops: 0 };
      chosen.push((await window.labmouse.call('make_maze', order)).maze);
    }
    const list = [];
    for (let i = 0; i < 3; ++i) {
      const begin = performance.now();
      for (const maze of chosen) await window.labmouse.call('contest', { mouse: 'certify', maze, seed: 1 });
      list.push(performance.now() - begin);
    }
    return { list, count: chosen.length };
  });
  note(`certify on ${times.count} contest mazes`, seconds(times.list), '2 s');
});

/** When things of the page could be seen first, as the page's own clock has it. */
async function watch(page: Page, places: Record<string, string>) {
  await page.addInitScript((wanted) => {
    window.seen = {};
    const look = () => {
      for (const [name, selector] of Object.entries(wanted))
        if (!(name in window.seen) && document.querySelector<HTMLElement>(selector)?.checkVisibility()) {
          const channel = new MessageChannel();
          window.seen[name] = NaN;
          // After the frame in which it is there has been painted.
          channel.port1.onmessage = () => (window.seen[name] = performance.now());
          channel.port2.postMessage(null);
        }
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  }, places);
}

/** Twenty built-in mice, among them those that are stochastic, in all mazes of the folder. */
function bigReport(mazes: string): string {
  const roster = native('mice')
    .split('\n')
    .filter((line) => /^\w/.test(line));
  const mice = roster
    .map((line) => line.split(' ')[0])
    .filter((name) => name !== 'oracle')
    .slice(0, 20);
  const [folder, file] = [temporary('race'), temporary('report.html')];
  native('race', '--mice', mice.join(), '--mazes', mazes, '--runs', '1', '--out', folder);
  native('report', folder, '-o', file, '--page', builtPage);
  return file;
}

const places = {
  table: '.race table tbody tr:nth-child(20)',
  matrix: '.race .pictures canvas',
  duel: '.race .bars',
};

test.skipIf(!manyMazes)('a large report', { timeout: 300_000 }, async () => {
  const file = process.env.LABMOUSE_REPORT ?? bigReport(manyMazes!);
  const count = readdirSync(manyMazes!).filter((name) => name.endsWith('.txt')).length;
  note(`report of 20 mice in ${count} mazes, size`, megabytes(file), '8 MB');
  const seen: Record<string, number>[] = [];
  for (let i = 0; i < 7; ++i) {
    const page = await open('', { file, before: (fresh) => watch(fresh, places) });
    await page.waitForFunction((names) => names.every((name) => window.seen[name] > 0), Object.keys(places));
    seen.push(await page.evaluate(() => window.seen));
    await page.close();
  }
  for (const name of Object.keys(places))
    note(`… its ${name} is seen after`, seconds(seen.map((one) => one[name])), name === 'table' ? '1 s' : '');
});

test('a replay of 32 by 32 cells', async () => {
  const [maze, record] = [temporary('large.txt'), temporary('large.jsonl')];
  native('make', 'contest', '--size', '32x32', '--seed', '7', '-o', maze);
  native('run', 'certify', maze, '--budget', '4000', '--record', record);
  const page = await open('#replay');
  await drop(page, { name: 'large.jsonl', content: readFileSync(record) });
  await replayed(page, '32 × 32');
  // At 64× the contest takes two seconds: one that stood at its end would count no frames.
  await page.getByRole('button', { name: 'Repeat from the start' }).click();
  for (const speed of ['8×', '64×']) {
    await page.keyboard.press('Home');
    await page.getByRole('combobox', { name: /^Speed/ }).selectOption(speed);
    const { rate, costs } = await page.locator('.replay .player').evaluate(async (player) => {
      const { meter } = player as unknown as { meter: Meter };
      player.querySelector<HTMLButtonElement>('button[aria-label=Play]')!.click();
      const [before, begin] = [meter.frames, performance.now()];
      await new Promise((done) => setTimeout(done, 4000));
      const [count, time] = [meter.frames - before, performance.now() - begin];
      player.querySelector<HTMLButtonElement>('button[aria-label=Pause]')?.click();
      return { rate: (1000 * count) / time, costs: [...meter.costs].filter((cost) => cost > 0).slice(-count) };
    });
    const late = costs.filter((cost) => cost > 1000 / 60).length;
    note(
      `replay of 32 by 32 cells at ${speed}`,
      `${rate.toFixed(0)} frames/s, a frame costs ${median(costs).toFixed(2)} ms; ${late} above 16.7 ms`,
      '60 frames/s',
    );
  }
});
