import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, keptInBrowser, open, picture } from './harness';

const board = (page: Page) => page.getByRole('application', { name: /^Drawing of/ });
const verdict = (page: Page) => page.getByRole('region', { name: 'Judgement' }).getByRole('status');
const undo = (page: Page) => page.getByRole('button', { name: 'Undo' });
const shown = async (page: Page) => (await board(page).getAttribute('aria-label'))!;

async function openDraw(hash = '#draw', options = {}) {
  const page = await open(hash, options);
  await board(page).waitFor();
  await expect.poll(() => verdict(page).textContent()).not.toBe('');
  return page;
}

/** Where a place of the maze, in cells from the south-west corner, is on the screen. */
async function places(page: Page, width = 16, height = 16) {
  const box = (await board(page).boundingBox())!;
  const pitch = Math.floor(Math.min((box.width - 24) / width, (box.height - 20) / height));
  return (x: number, y: number): [number, number] => [box.x + 24 + x * pitch, box.y + box.height - 20 - y * pitch];
}

async function drag(page: Page, from: [number, number], to: [number, number]) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 6 });
  await page.mouse.up();
}

/** The file that a button of Save gives. */
async function saved(page: Page, name: string) {
  const download = page.waitForEvent('download');
  await page.getByRole('region', { name: 'Save' }).getByRole('button', { name, exact: true }).click();
  const file = await download;
  return { name: file.suggestedFilename(), content: readFileSync(await file.path()) };
}

async function openInDraw(page: Page, name: string, content: Buffer) {
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('region', { name: 'New drawing' }).getByRole('button', { name: 'Open a file…' }).click();
  await (await chooser).setFiles({ name, mimeType: 'application/octet-stream', buffer: content });
}

test('walls are drawn by clicks and drags, judged, and undone', async () => {
  const page = await openDraw();
  const at = await places(page);
  await page.mouse.click(...at(1, 0.5));
  await expect.poll(() => verdict(page).textContent()).toContain('2 of 10 contest rules');
  await drag(page, at(0.5, 1), at(4.5, 1));
  await expect.poll(() => verdict(page).textContent()).toBe('No goal can be reached from the start.');
  await page.keyboard.press('Control+z');
  await expect.poll(() => verdict(page).textContent()).toContain('2 of 10 contest rules');
  await page.keyboard.press('Control+Shift+Z');
  await expect.poll(() => verdict(page).textContent()).toBe('No goal can be reached from the start.');
  await undo(page).click();
  await undo(page).click();
  expect(await undo(page).isDisabled()).toBe(true);
});

test('all is drawn by keyboard, too, and each step is said', async () => {
  const page = await openDraw();
  const said = page.locator('.draw-board [aria-live]');
  await board(page).focus();
  for (const [key, words] of [
    ['ArrowUp', '(0,1): walls west'],
    ['d', 'east of (0,1) closed'],
    ['Shift+ArrowRight', 'east of (0,1) open'],
    ['a', 'west of (0,1) is the border, which stays closed'],
    ['h', 'the start is (0,1)'],
    ['r', 'the start heads east'],
    ['g', '(0,1) is a goal'],
  ]) {
    await page.keyboard.press(key);
    expect(await said.textContent()).toBe(words);
  }
});

test('why the last goal stays is told below the board', async () => {
  const page = await openDraw();
  const form = page.getByRole('region', { name: 'New drawing' });
  await form.getByLabel('Width').fill('3');
  await form.getByLabel('Height').fill('3');
  await form.getByRole('button', { name: 'New drawing' }).click();
  await expect.poll(() => shown(page)).toBe('Drawing of 3 by 3 cells');
  await page.getByRole('radio', { name: 'Goals' }).check();
  const at = await places(page, 3, 3);
  await page.mouse.click(...at(1.5, 1.5));
  await page.getByText('a maze must have at least one goal').waitFor();
  const box = (await page.getByText('a maze must have at least one goal').boundingBox())!;
  expect(box.width).toBeGreaterThan(100);
});

test('a finger draws without moving the page', async () => {
  const page = await openDraw('#draw', { viewport: { width: 390, height: 844 }, hasTouch: true });
  const at = await places(page);
  await page.touchscreen.tap(...at(1, 0.5));
  await expect.poll(() => verdict(page).textContent()).toContain('2 of 10 contest rules');
  expect(await board(page).evaluate((canvas) => getComputedStyle(canvas).touchAction)).toBe('none');
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)).toBe(true);
  expect(await barriers(page)).toEqual([]);
  await picture(page, 'draw-phone');
});

test('every format is saved and opened again, and what a format cannot hold is refused', async () => {
  const page = await openDraw();
  const form = page.getByRole('region', { name: 'New drawing' });
  await form.getByLabel('Kind').selectOption('contest');
  await form.getByRole('button', { name: 'New drawing' }).click();
  await expect.poll(() => verdict(page).textContent()).toBe('A contest maze: it follows all 10 rules.');
  await picture(page, 'draw');
  expect(await barriers(page)).toEqual([]);
  const files = [];
  for (const format of ['drawing', 'capstone', 'num', 'maz']) files.push(await saved(page, format));
  for (const file of files) {
    await form.getByLabel('Kind').selectOption('closed');
    await form.getByRole('button', { name: 'New drawing' }).click();
    await expect.poll(() => verdict(page).textContent()).toBe('No goal can be reached from the start.');
    await openInDraw(page, file.name, file.content);
    await expect.poll(() => verdict(page).textContent()).toBe('A contest maze: it follows all 10 rules.');
  }
  expect((await saved(page, 'picture')).content.toString()).toContain('<svg');
  await page.getByRole('button', { name: 'Turn start' }).click();
  await page.getByRole('region', { name: 'Save' }).getByRole('button', { name: 'capstone' }).click();
  await expect.poll(() => page.getByRole('region', { name: 'Save' }).getByRole('alert').textContent()).toMatch(/start/);
});

test('a bad file leaves the drawing untouched', async () => {
  const page = await openDraw();
  const at = await places(page);
  await page.mouse.click(...at(1, 0.5));
  await openInDraw(page, 'bad.txt', Buffer.from('12\n1,2,x\n'));
  await page.getByRole('alert').filter({ hasText: 'bad.txt' }).waitFor();
  expect(await shown(page)).toBe('Drawing of 16 by 16 cells');
  await undo(page).click();
  expect(await undo(page).isDisabled()).toBe(true);
});

test('a link holds the maze; opening one is a step that can be undone', async () => {
  const page = await openDraw();
  const form = page.getByRole('region', { name: 'New drawing' });
  await form.getByLabel('Width').fill('5');
  await form.getByLabel('Height').fill('4');
  await form.getByRole('button', { name: 'New drawing' }).click();
  await page.getByRole('region', { name: 'Save' }).getByRole('button', { name: 'link' }).click();
  const field = page.getByLabel('Link containing the maze');
  await field.waitFor();
  const link = await field.inputValue();
  expect(link).toMatch(/#maze=[\w.-]+$/);

  const other = await openDraw(`#${link.split('#')[1]}`);
  await expect.poll(() => shown(other)).toBe('Drawing of 5 by 4 cells');
  await undo(other).click();
  expect(await shown(other)).toBe('Drawing of 16 by 16 cells');

  const cut = await openDraw(`#${link.split('#')[1].slice(0, -3)}`);
  await cut.getByRole('alert').filter({ hasText: /./ }).first().waitFor();
  expect(await shown(cut)).toBe('Drawing of 16 by 16 cells');
});

test('a mouse runs in what was drawn', async () => {
  const page = await openDraw();
  const at = await places(page);
  await page.mouse.click(...at(1, 0.5));
  const name = page.getByRole('region', { name: 'Drawing', exact: true }).getByLabel('Name');
  await name.fill('my maze');
  await page.getByRole('button', { name: 'Run a mouse here' }).click();
  const live = page.getByRole('region', { name: 'Live' });
  await live.getByText('ariadne in my maze: finished').waitFor();
  await live.getByRole('button', { name: 'Edit in Draw' }).click();
  await board(page).waitFor();
  expect(await name.inputValue()).toBe('my maze');
});

test('on a phone a new drawing and its first walk are brought into sight', async () => {
  const page = await openDraw('#draw', { viewport: { width: 390, height: 844 } });
  const inSight = (place: ReturnType<typeof board>) =>
    expect.poll(async () => {
      const box = await place.boundingBox();
      return box !== null && box.y >= 0 && box.y + box.height <= 844;
    });
  await page.getByRole('region', { name: 'New drawing' }).getByRole('button', { name: 'New drawing' }).click();
  await inSight(board(page)).toBe(true);
  await page.getByRole('button', { name: 'Run a mouse here' }).click();
  await inSight(page.getByRole('region', { name: 'Live' }).locator('canvas')).toBe(true);
});

test('the drawing survives a reload', async () => {
  const page = await openDraw();
  const form = page.getByRole('region', { name: 'New drawing' });
  await form.getByLabel('Width').fill('7');
  await form.getByRole('button', { name: 'New drawing' }).click();
  const kept = () => keptInBrowser(page, 'drawing');
  await expect.poll(kept).not.toBe('null');
  const before = await kept();
  await page.getByRole('button', { name: 'Turn start' }).click();
  await expect.poll(kept).not.toBe(before);
  await page.reload();
  await board(page).waitFor();
  expect(await shown(page)).toBe('Drawing of 7 by 16 cells');
});

test('only a maze that follows all contest rules is marked as good, and each figure says what it is', async () => {
  const page = await openDraw();
  const state = () => verdict(page).getAttribute('data-state');
  await expect.poll(state).toBe('fair');
  const form = page.getByRole('region', { name: 'New drawing' });
  await form.getByLabel('Kind').selectOption('contest');
  await form.getByRole('button', { name: 'New drawing' }).click();
  await expect.poll(state).toBe('good');
  const judgement = page.getByRole('region', { name: 'Judgement' });
  await judgement.locator('.meanings summary').click();
  expect(await judgement.locator('.meanings dd:visible').count()).toBe(await judgement.locator('.figures dt').count());
});
