import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, native, open, picture, proof } from './harness';

const live = (page: Page) => page.getByRole('region', { name: 'Live' });
const outcome = (page: Page) => live(page).locator('.verdict');
const comparison = (page: Page) => live(page).locator('.comparison');
const mouse = (page: Page) => page.getByRole('region', { name: 'Mouse' }).getByLabel('Name');
const spec = (page: Page) => page.getByLabel('The mouse for the command line').inputValue();

async function openLive(hash = '#live', options = {}) {
  const page = await open(hash, options);
  await expect.poll(() => outcome(page).textContent()).toContain('score');
  return page;
}

test('a mouse runs at once, as the program runs it', async () => {
  const page = await openLive();
  await mouse(page).selectOption('certify');
  await expect.poll(() => outcome(page).textContent()).toContain('certify in capstone-1');
  const score = /score ([\d.]+)/.exec(native('run', 'certify', 'capstone-1'))![1];
  expect(await outcome(page).textContent()).toContain(`score ${score}`);
});

test('a parameter changes the walk, which is compared with the one before', async () => {
  const page = await openLive();
  await page.getByLabel('travel', { exact: true }).fill('10');
  await expect.poll(() => comparison(page).textContent()).toMatch(/^ariadne → ariadne:travel=10: /);
  expect(await spec(page)).toBe('ariadne:travel=10');
  await page.getByLabel('Compare with before').check();
  await picture(page, 'live');
  expect(await barriers(page)).toEqual([]);
  await page.getByRole('button', { name: 'Back to defaults' }).click();
  await expect.poll(() => comparison(page).textContent()).toMatch(/^ariadne:travel=10 → ariadne: /);
});

test('what is wrong stands at its field, in the words of the core', async () => {
  const page = await openLive();
  const travel = page.getByLabel('travel', { exact: true });
  await travel.fill('1000');
  const refusal = page.locator('.field-error', {
    hasText: "of parameter 'travel' of mouse 'ariadne' is outside the range 1 to 200",
  });
  await refusal.waitFor();
  expect(await travel.getAttribute('aria-invalid')).toBe('true');
  expect(await outcome(page).textContent()).toMatch(/^Not run: .*of parameter 'travel'/);
  await travel.fill('20');
  await refusal.waitFor({ state: 'detached' });
  await expect.poll(() => outcome(page).textContent()).toContain('ariadne:travel=20 in capstone-1: finished');
  const maze = page.getByRole('region', { name: 'Maze', exact: true });
  await maze.getByLabel('From').selectOption('generator');
  await maze.getByLabel('Kind').selectOption('contest');
  await maze.getByLabel('Width').fill('15');
  await maze.getByText('a contest maze must be a square').waitFor();
  await maze.getByLabel('Width').fill('12');
  await maze.getByLabel('Height').fill('12');
  await expect.poll(() => outcome(page).textContent()).toContain('contest-12x12-seed-1');
});

test('the form has the parameters that count in the world', async () => {
  const page = await openLive();
  const number = (name: string) => page.getByLabel(name, { exact: true });
  expect(await number('cell_most').count()).toBe(0);
  await page.getByRole('region', { name: 'Contest' }).getByLabel('World').selectOption('seconds');
  await number('cell_most').fill('1');
  expect(await number('travel').count()).toBe(0);
  expect(await number('prior').count()).toBe(1);
  expect(await spec(page)).toBe('ariadne:cell_most=1');
  await expect.poll(() => outcome(page).textContent()).toContain('ariadne:cell_most=1 in capstone-1');
});

test('an empty number is not taken for 0', async () => {
  const page = await openLive();
  const contest = page.getByRole('region', { name: 'Contest' });
  await contest.getByLabel('Seed').fill('');
  await contest.getByText("'seed' is not a number").waitFor();
  await expect.poll(() => outcome(page).textContent()).toContain("'seed' is not a number");
  await contest.getByLabel('Seed').fill('2');
  await expect.poll(() => outcome(page).textContent()).toContain('finished');
});

test('all mice race; a click on one shows its walk', async () => {
  const page = await openLive();
  await page.getByRole('button', { name: 'Race all mice on this maze' }).click();
  const table = page.getByRole('region', { name: 'All mice' }).getByRole('table');
  await page.getByText(/^\d+ mice have raced/).waitFor();
  const first = table.getByRole('rowheader').first();
  expect(await first.textContent()).toBe('oracle reference');
  await table.getByRole('button', { name: 'Search' }).click();
  await table.getByRole('button', { name: 'Search' }).click();
  expect(await table.locator('[aria-sort=descending]').textContent()).toBe('Search');
  expect(await first.textContent()).toBe('random-move');
  await picture(page, 'live-all-mice');
  await table.getByRole('button', { name: 'two-way' }).click();
  await expect.poll(() => outcome(page).textContent()).toContain('two-way in capstone-1');
  expect(await mouse(page).inputValue()).toBe('two-way');
});

test('a race can be stopped', async () => {
  const page = await openLive();
  const begin = page.getByRole('button', { name: 'Race all mice on this maze' });
  await begin.evaluate((button: HTMLButtonElement) => {
    button.click();
    [...document.querySelectorAll('button')].find(({ textContent }) => textContent === 'Stop')!.click();
  });
  await page.getByText('Stopped.').waitFor();
  expect(await begin.isEnabled()).toBe(true);
  // The core answers in order: what is asked now comes after what was under way.
  await mouse(page).selectOption('flood');
  await expect.poll(() => outcome(page).textContent()).toContain('flood in');
  expect(await page.getByRole('region', { name: 'All mice' }).locator('tbody tr').count()).toBe(0);
});

test.runIf(proof)('the address holds mouse, maze and seed', async () => {
  const page = await openLive();
  await mouse(page).selectOption('visit-counter');
  await page.getByLabel('coverage').fill('0.5');
  await page.getByRole('region', { name: 'Contest' }).getByLabel('Seed').fill('7');
  await expect.poll(() => page.url()).toMatch(/#live&mouse=visit-counter:coverage=0.5&in=capstone-1&seed=7$/);
  const before = await outcome(page).textContent();
  const other = await openLive(`#${page.url().split('#')[1]}`);
  await expect.poll(() => outcome(other).textContent()).toBe(before);
  expect(await spec(other)).toBe('visit-counter:coverage=0.5');
  await page.reload();
  await expect.poll(() => outcome(page).textContent()).toBe(before);
});

test('a strange address breaks nothing', async () => {
  const page = await open('#live&mouse=nobody:a=%3Cb%3E');
  await page.locator('.field-error', { hasText: /unknown mouse 'nobody'/ }).waitFor();
  expect(await outcome(page).textContent()).toMatch(/^Not run: .*unknown mouse 'nobody'/);
  await mouse(page).selectOption('flood');
  await expect.poll(() => outcome(page).textContent()).toContain('flood in capstone-1: finished');
});

test('it works on a phone, in the dark', async () => {
  const page = await openLive('#live', { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)).toBe(true);
  expect(await barriers(page)).toEqual([]);
  await picture(page, 'live-phone');
});
