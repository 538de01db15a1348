// Where the mice of a race lose their steps.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, native, open, picture, temporary, themes } from './harness';

const part = (page: Page) => page.getByRole('region', { name: 'Where steps are lost' });

async function openHeat(options = {}) {
  const page = await open(
    '#race&mouse=flood&mouse=certify&mouse=ariadne&mouse=visit-counter&in=contest-02&seed=4&runs=5',
    options,
  );
  await part(page).getByRole('button', { name: 'Show where' }).click();
  await part(page).locator('canvas').waitFor();
  return page;
}

test('what is lost in all cells is what the scores are above the best possible one', async () => {
  const page = await openHeat();
  const [{ mice, mazes }] = JSON.parse(
    native(
      ...['race', '--mice', 'flood,certify,ariadne,visit-counter', '--mazes', 'contest-02'],
      ...['--seed', '4', '--runs', '5', '--format', 'json'],
    ),
  ).groups as {
    mice: { results: { score: number | null; speed_steps: number }[] }[];
    mazes: { bound: number; optimum: number }[];
  }[];
  const finished = mice.flatMap(({ results }) => results).filter(({ score }) => score !== null);
  expect(finished.length).toBeGreaterThan(2);
  const mean = (list: number[]) => list.reduce((sum, one) => sum + one, 0) / list.length;
  const loss = mean(finished.map(({ score }) => score! - mazes[0].bound));
  const words = part(page).locator('.words');
  expect(await words.textContent()).toContain(`loses ${loss.toFixed(2)} points`);
  // The picture says the same to those who do not see it.
  expect(await part(page).getByRole('img').getAttribute('aria-label')).toContain(await words.textContent());
  await part(page).getByLabel('Show what is lost').selectOption('speed');
  const steps = mean(finished.map(({ speed_steps }) => speed_steps - mazes[0].optimum));
  await expect.poll(() => words.textContent()).toContain(`loses ${steps.toFixed(2)} steps`);
  expect(await part(page).locator('.scale li').count()).toBe(6);
});

test('its picture can be saved', async () => {
  const page = await openHeat();
  const waiting = page.waitForEvent('download');
  await part(page).getByRole('button', { name: 'Save as PNG' }).click();
  const path = temporary('lost-steps.png');
  await (await waiting).saveAs(path);
  const png = readFileSync(path);
  expect([png.subarray(1, 4).toString(), png.readUInt32BE(16) > 1000]).toEqual(['PNG', true]);
  const drawing = page.waitForEvent('download');
  await part(page).getByRole('button', { name: 'Save as SVG' }).click();
  await (await drawing).saveAs(temporary('lost-steps.svg'));
  expect(readFileSync(temporary('lost-steps.svg'), 'utf8')).toContain('Where steps are lost in contest-02');
});

test.each(themes)('it is without barriers in the %s, on a telephone too', async (colorScheme) => {
  const page = await openHeat({ colorScheme, viewport: { width: 390, height: 844 } });
  await part(page).scrollIntoViewIfNeeded();
  await picture(page, `heat-${colorScheme}`);
  expect(await barriers(page)).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
});
