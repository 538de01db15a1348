// Nobody is kept out: every view in both themes, with all that folds unfolded, empty and at work.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { Core } from '../../src/core/client';
import { barriers, drop, native, open, temporary, themes } from './harness';

declare global {
  interface Window {
    labmouse: Core;
  }
}

/** Waits until what was asked of the core is answered and drawn, unfolds all that can be seen, and asks axe. */
async function expectNoBarriers(page: Page, place: string) {
  await page.evaluate(async () => {
    await window.labmouse.call('builtin_maze', { name: 'capstone-1' });
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    for (const folded of document.querySelectorAll('details')) if (folded.checkVisibility()) folded.open = true;
  });
  expect(await barriers(page), place).toEqual([]);
}

test.each(themes)('every view is without barriers when %s', async (colorScheme) => {
  const page = await open('', { colorScheme, reducedMotion: 'reduce' });
  await expectNoBarriers(page, 'the home page');
  const views = page.getByRole('navigation', { name: 'Views' }).getByRole('link');
  const names = await views.allTextContents();
  expect(names.length).toBeGreaterThanOrEqual(4);
  for (const name of names) {
    await views.filter({ hasText: name }).click();
    await page.waitForFunction((title) => document.title.startsWith(title), name);
    await expectNoBarriers(page, name);
  }
});

test.each(themes)('results, a replay and a complaint are without barriers when %s', async (theme) => {
  const page = await open('#race', { colorScheme: theme });
  await drop(page, { name: 'bad.txt', content: 'no maze' });
  await page.getByRole('alert').getByText('bad.txt').first().waitFor();
  const mazes = ['capstone-1', 'contest-05'];
  const results = native('race', '--mice', 'flood,certify', '--mazes', ...mazes, '--format', 'json');
  await drop(page, { name: 'results.json', content: results });
  await page.getByRole('region', { name: 'Leaderboard, table' }).waitFor();
  await expectNoBarriers(page, 'results');
  const records = ['ariadne', 'flood'].map((mouse) => {
    const file = temporary(`${mouse}-access.jsonl`);
    native('run', mouse, 'capstone-1', '--explain', '--record', file);
    return { name: `${mouse}.jsonl`, content: readFileSync(file) };
  });
  await drop(page, ...records);
  await page.locator('.replay .player canvas').nth(1).waitFor();
  await page.keyboard.press('End');
  await expectNoBarriers(page, 'a replay of two');
});
