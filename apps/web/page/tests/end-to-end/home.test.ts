// The front door: a race that runs at once, and where one goes from it.
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, open, picture } from './harness';

const clock = async (page: Page) => Number(await page.getByRole('timer').textContent());
const frames = (page: Page) =>
  page.locator('.front-race').evaluate((race) => (race as unknown as { meter: { frames: number } }).meter.frames);
async function opened(options = {}) {
  const page = await open('', options);
  await page.locator('.lane canvas').first().waitFor();
  return page;
}

test('a race runs at once, with its clock, both mice and the gap between them', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(1);
  expect(await page.locator('.lane').count()).toBe(2);
  await expect.poll(() => page.locator('.gap').textContent()).not.toBe('');
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await barriers(page)).toEqual([]);
  }
  await picture(page, 'home');
});

test('it stands still where it was stopped, and where less motion is asked for', async () => {
  const page = await opened();
  await page.getByRole('button', { name: 'Pause' }).click();
  const stopped = [await clock(page), await frames(page)];
  await page.getByRole('button', { name: 'Another race' }).click();
  await expect.poll(() => clock(page)).toBe(0);
  expect(await frames(page)).toBe(stopped[1]);
  const still = await opened({ reducedMotion: 'reduce' });
  await still.getByRole('button', { name: 'Run', exact: true }).waitFor();
  expect([await clock(still), await frames(still)]).toEqual([0, 0]);
  await still.getByRole('button', { name: 'Run', exact: true }).click();
  await expect.poll(() => clock(still)).toBeGreaterThan(0);
});

test('it costs nothing while another view is shown, and goes on afterwards', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(0);
  await page.getByRole('link', { name: 'Draw' }).click();
  await page.locator('.draw .stage canvas').waitFor();
  const before = await frames(page);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  expect(await frames(page)).toBe(before);
  await page.goBack();
  await expect.poll(() => frames(page)).toBeGreaterThan(before);
});

test('who wants to see it closely is taken to that moment of it', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(2);
  await page.getByRole('button', { name: 'Pause' }).click();
  const time = await clock(page);
  const [first] = await page.locator('.lane strong').allTextContents();
  await page.getByRole('button', { name: 'Watch' }).click();
  await expect.poll(() => page.locator('.replay .moment').textContent()).toContain(`${first} at `);
  const moment = (await page.locator('.replay .moment').textContent())!;
  expect(Number(/ at ([\d.]+) of/.exec(moment)![1])).toBeCloseTo(time, 1);
});

test('on a telephone both mazes and all ways on are on the first screen', async () => {
  const page = await opened({ viewport: { width: 390, height: 844 }, hasTouch: true });
  for (const place of [
    ...(await page.locator('.lane canvas').all()),
    page.getByRole('link', { name: 'Race', exact: true }).last(),
  ]) {
    const box = (await place.boundingBox())!;
    expect(box.y + box.height).toBeLessThanOrEqual(844);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
});
