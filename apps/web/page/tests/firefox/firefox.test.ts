// What has to work in another browser than that of all other tests: the core, its worker, a stage, a race.
import { readFileSync } from 'node:fs';
import type { Page } from 'puppeteer-core';
import { afterAll, afterEach, expect, test } from 'vitest';
import type { Core } from '../../src/core/client';
import type { RaceResults } from '../../src/core/types';
import { native, proof, temporary } from '../end-to-end/harness';
import { complained, endOfTest, endOfTests, open } from './firefox';

declare global {
  interface Window {
    labmouse: Core;
  }
}

afterEach(endOfTest);
afterAll(endOfTests);

/** Presses the button of that name that can be seen. */
const press = (page: Page, name: string) => page.locator(`::-p-aria([name="${name}"][role="button"])`).click();

// It computes for twenty seconds; `portable` does the same with V8.
test.runIf(process.env.LABMOUSE_PROOF)('the core behaves as the native program does', async () => {
  const page = await open('#draw');
  const { signature } = await page.evaluate(() => window.labmouse.call('signature', {}));
  expect(signature).toBe(native('bench', '--signature').trim());
});

test('a race moves on the home page', async () => {
  const page = await open();
  await page.waitForSelector('.lane canvas');
  const picture = () => page.$eval('.lane canvas', (canvas) => (canvas as HTMLCanvasElement).toDataURL());
  const before = await picture();
  await page.waitForFunction(() => Number(document.querySelector('[role=timer]')?.textContent) > 1);
  expect(await picture()).not.toBe(before);
});

test('a record is replayed to its end', async () => {
  const file = temporary('firefox.jsonl');
  const said = native('run', 'ariadne', 'capstone-1', '--record', file);
  const steps = readFileSync(file, 'utf8').match(/"step":/g)!.length;
  const page = await open('#replay');
  await page.evaluate(
    (content) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], 'walk.jsonl'));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    readFileSync(file, 'utf8'),
  );
  await page.waitForFunction(() => document.querySelector('.replay figcaption')?.textContent?.includes('capstone-1'));
  await page.keyboard.press('End');
  await page.waitForFunction(
    (count) => document.querySelector('.replay .moment')?.textContent?.includes(`after ${count} of ${count} steps`),
    {},
    steps,
  );
  const score = await page.evaluate(() => {
    const rows = [...document.querySelectorAll('.replay .facts tr')];
    return rows.find((row) => row.querySelector('th')?.textContent === 'score')?.querySelector('td')?.textContent;
  });
  expect(said).toContain(score);
});

test.runIf(proof)('a race has the leaderboard of the command line', async () => {
  const page = await open('#race');
  await page.waitForSelector('fieldset[aria-label=Mazes] input');
  const { mice, mazes } = await page.evaluate(() => {
    const boxes = (list: string) => [
      ...document.querySelectorAll<HTMLInputElement>(`fieldset[aria-label=${list}] input[type=checkbox]`),
    ];
    const chosen = (list: string) => boxes(list).flatMap((box) => (box.checked ? [box.value] : []));
    for (const maze of boxes('Mazes')) if (maze.checked !== maze.value.startsWith('capstone-')) maze.click();
    return { mice: chosen('Mice'), mazes: chosen('Mazes') };
  });
  await press(page, 'Start the race');
  const table = '[aria-label="Leaderboard, table"] tbody';
  const text = native('race', '--mice', mice.join(), '--mazes', ...mazes, '--format', 'json');
  const results = JSON.parse(text) as RaceResults;
  const shown = () =>
    page.$$eval(`${table} tr`, (rows) =>
      rows.map((row) => [row.querySelector('.name')?.textContent, row.querySelectorAll('td')[1]?.textContent]),
    );
  // While it is held it shows what there is so far.
  await expect
    .poll(shown, { timeout: 30_000 })
    .toEqual(results.groups[0].mice.map(({ name, mean_par1 }) => [name, Number(mean_par1).toFixed(3)]));
});

test('what the policy forbids is held back, and heard of here', async () => {
  const page = await open('#draw');
  expect(await page.evaluate(() => fetch('http://localhost:1/').then(String, () => 'held back'))).toBe('held back');
  await expect.poll(complained).toContainEqual(expect.stringMatching(/Content-Security-Policy.*connect-src/));
});
