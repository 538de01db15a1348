import { readFileSync, writeFileSync } from 'node:fs';
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, choose, drop, native, open, picture, proof, replayed, temporary } from './harness';

async function opened(mice = ['ariadne'], options = {}) {
  const page = await open('#replay', options);
  await choose(page, mice, 'capstone-1');
  return page;
}

const scrubber = (page: Page) => page.getByRole('slider', { name: 'Moment of the replay' });
const moment = async (page: Page) => (await page.locator('.replay .moment').textContent())!;
const steps = async (page: Page) => Number(/after (\d+) of/.exec(await moment(page))![1]);
const fact = async (page: Page, name: string, column = 0) =>
  page
    .locator('.replay .facts tr', { has: page.getByRole('rowheader', { name, exact: true }) })
    .locator('td')
    .nth(column)
    .textContent();
/** Presses a key and waits until the words say so many steps. */
async function press(page: Page, key: string, after: number) {
  await page.keyboard.press(key);
  await expect.poll(() => steps(page)).toBe(after);
}
/** The picture as data, to be compared. */
const pixels = (page: Page, at = 0) =>
  page
    .locator('.replay .player canvas')
    .nth(at)
    .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

test('an example is played, and the keys lead through it', async () => {
  const page = await opened();
  expect(await moment(page)).toContain('ariadne after 0 of 112 steps, search: at (0,0) north.');
  await press(page, 'ArrowRight', 1);
  await press(page, 'Shift+ArrowRight', 11);
  await press(page, 'ArrowLeft', 10);
  await press(page, 'End', 112);
  expect(await moment(page)).toContain('finished');
  expect([await fact(page, 'score so far'), await fact(page, 'score')]).toEqual(['20.167', '20.167']);
  await press(page, 'r', 95);
  expect(await fact(page, 'run')).toBe('speed run');
  await press(page, 'Home', 0);
  expect(await fact(page, 'score so far')).toBe('0.000');
});

test('an example plays by itself, and stands still where less motion is asked for', async () => {
  const page = await open('#replay');
  const quiet = await open('#replay', { reducedMotion: 'reduce' });
  const standing = (of: Page) => of.locator('.replay').getByRole('button', { name: 'Play', exact: true });
  await page.locator('.replay').getByRole('button', { name: 'Pause', exact: true }).waitFor();
  await expect.poll(async () => Number(await scrubber(page).inputValue())).toBeGreaterThan(0);
  await standing(quiet).waitFor();
  // What somebody chooses waits for them.
  await choose(page, ['flood'], 'capstone-1');
  await standing(page).waitFor();
  expect(await steps(page)).toBe(0);
  expect(await steps(quiet)).toBe(0);
});

test('there is an example at once, and who chooses another stays where they choose', async () => {
  const page = await open('#replay');
  const caption = page.locator('.replay figcaption h3');
  await expect.poll(() => caption.textContent()).toMatch(/^ariadne in .*16 × 16 cells/);
  const mouse = page.locator('.replay .choices').getByLabel('Mouse');
  await mouse.focus();
  await mouse.selectOption('flood');
  await expect.poll(() => caption.textContent()).toMatch(/^flood in /);
  expect(await mouse.evaluate((element) => element === document.activeElement)).toBe(true);
});

test('a mouse that was written stands beside ours', async () => {
  const page = await open('#write');
  await page.getByRole('region', { name: 'Write', exact: true }).getByLabel('Name').fill('my-own');
  await page.getByRole('link', { name: 'Replay' }).click();
  await choose(page, ['flood'], 'capstone-1');
  const mice = page.locator('.replay .choices').getByLabel('Beside it');
  await mice.selectOption({ label: 'my-own, in JavaScript' });
  await expect.poll(() => moment(page)).toContain('my-own after 0 of');
});

test('who opens a record is in the player', async () => {
  const file = temporary('own.jsonl');
  native('run', 'flood', 'contest-02', '--record', file);
  const page = await open('#replay');
  await drop(page, { name: 'own.jsonl', content: readFileSync(file) });
  await expect.poll(() => moment(page)).toContain('flood after 0 of');
  const focused = (place: Locator) => place.evaluate((element) => element === document.activeElement);
  expect(await focused(page.getByRole('group', { name: 'Player' }))).toBe(true);
  await page.keyboard.press('Tab');
  expect(await focused(scrubber(page))).toBe(true);
  expect(await page.locator('.replay .choices').getAttribute('open')).toBeNull();
});

test('it plays, and stops at the end', async () => {
  const page = await opened();
  await page.getByRole('combobox', { name: /^Speed/ }).selectOption('64×');
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Pause' }).waitFor();
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await expect.poll(() => steps(page)).toBe(112);
  const frames = await page
    .locator('.replay .player')
    .evaluate((player) => (player as unknown as { meter: { frames: number } }).meter.frames);
  expect(frames).toBeGreaterThan(2);
});

test('what was scrubbed is drawn the same forwards and backwards', async () => {
  const page = await opened();
  for (const key of ['2', '4', '6', '8', '9']) await page.keyboard.press(key);
  const at = async (frame: number) => {
    await scrubber(page).fill(String(frame));
    await expect.poll(() => steps(page)).toBe(frame);
    return pixels(page);
  };
  const [first, later] = [await at(40), await at(100)];
  expect(first).not.toBe(later);
  await at(0);
  expect(await at(40)).toBe(first);
  await at(112);
  expect(await at(100)).toBe(later);
  expect(await scrubber(page).getAttribute('aria-valuetext')).toContain('after 100 of 112 steps');
});

test('each layer changes the picture, and is kept', async () => {
  const page = await opened();
  await page.keyboard.press('End');
  await expect.poll(() => steps(page)).toBe(112);
  let before = await pixels(page);
  for (const key of ['1', '2', '3', '4', '6', '7', '8', '9']) {
    await page.keyboard.press(key);
    await expect.poll(() => pixels(page), { message: key }).not.toBe(before);
    before = await pixels(page);
  }
  expect(await page.locator('.replay').getByLabel('Visits').isChecked()).toBe(false);
  expect(await page.locator('.replay .legend').textContent()).toContain('steps to the goal, in the whole maze');
  await choose(page, ['flood'], 'capstone-1');
  expect(await page.locator('.replay').getByLabel('Wrong guesses').isChecked()).toBe(true);
  expect(await page.locator('.replay').getByLabel('Walls').inputValue()).toBe('whole');
});

test('the list of steps follows, and leads', async () => {
  const page = await opened();
  const current = page.locator('.replay .steps tr[aria-current]');
  await press(page, 'r', 95);
  expect(await current.getByRole('button').textContent()).toBe('96');
  expect(await current.isVisible()).toBe(true);
  await page.locator('.replay .steps tbody').getByRole('button', { name: 'step 97' }).click();
  await expect.poll(() => steps(page)).toBe(96);
  expect(await current.getByRole('button').textContent()).toBe('97');
});

test('reasons are told, and why it stopped', async () => {
  const page = await opened();
  const reasons = page.locator('.replay .reasons');
  await press(page, 'ArrowRight', 1);
  expect(await reasons.locator('.chosen th').textContent()).toContain('(3,2) north');
  await reasons.getByRole('button', { name: 'and 10 more' }).click();
  expect(await reasons.locator('tbody tr:visible').count()).toBe(16);
  await press(page, 'End', 112);
  expect(await reasons.textContent()).toContain('The best known run takes 17 steps. The best hope is one of 18.4');
});

test('two mice run on one clock and are compared', async () => {
  const page = await opened(['ariadne', 'flood']);
  await press(page, 'ArrowRight', 1);
  expect(await moment(page)).toContain('flood after 1 of 52 steps');
  await press(page, 'End', 112);
  expect(await moment(page)).toContain('flood after 52 of 52 steps');
  expect(await fact(page, 'score', 2)).toBe('−1.867');
  await page.getByRole('columnheader', { name: 'ariadne − flood' }).waitFor();
  await page.getByRole('button', { name: 'flood' }).click();
  await page.locator('.replay .reasons').waitFor({ state: 'hidden' });
  await page.getByRole('button', { name: 'Speed run', exact: true }).click();
  await expect.poll(() => moment(page)).toContain('flood after 31 of 52 steps, speed run');
  await picture(page, 'replay-two');
});

test('plays of one mouse in two mazes are told apart, and not compared', async () => {
  const [one, two] = [temporary('one.jsonl'), temporary('two.jsonl')];
  native('run', 'flood', 'capstone-1', '--record', one);
  native('run', 'flood', 'contest-01', '--record', two);
  const page = await open('#replay');
  await drop(page, ...[one, two].map((file) => ({ name: file, content: readFileSync(file) })));
  await page.getByRole('columnheader', { name: 'flood, contest-01' }).waitFor();
  expect(await moment(page)).toContain('flood, capstone-1 after 0 of');
  expect(await page.locator('.replay .facts thead th').count()).toBe(2);
});

test('the record is saved as it was made', async () => {
  const page = await opened();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save record' }).click(),
  ]);
  expect(download.suggestedFilename()).toBe('ariadne-capstone-1.jsonl');
  const lines = readFileSync((await download.path())!, 'utf8')
    .trim()
    .split('\n');
  expect(lines).toHaveLength(114);
  expect(JSON.parse(lines[113])).toMatchObject({ outcome: 'finished', search_steps: 95 });
});

test('keys are left to fields that need them, and to other views', async () => {
  const page = await opened();
  await page.locator('.replay').getByLabel('Distances').focus();
  await page.keyboard.press('ArrowDown');
  expect(await page.locator('.replay').getByLabel('Distances').inputValue()).toBe('true');
  expect(await steps(page)).toBe(0);
  await page.getByRole('link', { name: 'Race' }).click();
  await page.locator('.replay .player').waitFor({ state: 'hidden' });
  await page.keyboard.press('End');
  await page.getByRole('link', { name: 'Replay' }).click();
  expect(await steps(page)).toBe(0);
});

test('who wants less motion sees whole steps', async () => {
  const page = await opened(undefined, { reducedMotion: 'reduce' });
  await scrubber(page).fill('3');
  await expect.poll(() => steps(page)).toBe(3);
  const whole = await pixels(page);
  await scrubber(page).fill('3.6');
  expect(await pixels(page)).toBe(whole);
});

test.runIf(proof)('nothing is in the way of anybody, in light and dark, at every width', async () => {
  const page = await open('#replay');
  await choose(page, ['ariadne'], 'capstone-1');
  expect(await barriers(page)).toEqual([]);
  await scrubber(page).fill('100');
  for (const key of ['6', '9']) await page.keyboard.press(key);
  await expect.poll(() => steps(page)).toBe(100);
  for (const colorScheme of ['light', 'dark'] as const)
    for (const width of [1280, 390]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 844 });
      if ((colorScheme === 'light') === (width === 1280)) expect(await barriers(page)).toEqual([]);
      await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
      await picture(page, `replay-${colorScheme}-${width}`);
    }
});

const program = `
import sys
def ask(line):
    print(line, flush=True)
    return input()
print("setColor 0 0 G", flush=True)
print("setText 0 0 hello you", flush=True)
print("setWall 0 0 e", flush=True)
ask("moveForwardHalf")
ask("turnRight45")
ask("turnLeft45")
print("clearAllColor", flush=True)
ask("moveForwardHalf")
print("<b>bye</b>", file=sys.stderr)
`;

test('a program for mms is replayed with what it drew', async () => {
  const [file, record] = [temporary('draws.py'), temporary('draws.jsonl')];
  writeFileSync(file, program);
  native('mms', `python3 ${file}`, '--maze', 'capstone-1', '--record', record);
  const page = await open('#replay');
  await drop(page, { name: 'draws.jsonl', content: readFileSync(record) });
  await replayed(page, 'mms:');
  const drawn = page.locator('.replay').getByLabel('Drawn by the program');
  const painted = await pixels(page);
  await drawn.uncheck();
  await expect.poll(() => pixels(page)).not.toBe(painted);
  await drawn.check();
  await expect.poll(() => pixels(page)).toBe(painted);
  await press(page, 'ArrowRight', 1);
  expect(await fact(page, 'mouse at')).toBe('(0,0.5) north');
  await press(page, 'ArrowRight', 2);
  expect(await fact(page, 'mouse at')).toBe('(0,0.5) north-east');
  await press(page, 'End', 4);
  expect(await page.locator('.replay .words pre').textContent()).toContain('<b>bye</b>');
  expect(await page.getByRole('button', { name: 'Speed run' }).isVisible()).toBe(false);
});

test('what the mouse believed is asked of the core', async () => {
  const page = await opened();
  await press(page, 'ArrowRight', 1);
  const before = await pixels(page);
  await page.locator('.replay').getByLabel('Distances').selectOption('true');
  await expect.poll(() => pixels(page)).not.toBe(before);
  const whole = await pixels(page);
  await page.locator('.replay').getByLabel('Distances').selectOption('believed');
  await expect.poll(() => pixels(page)).not.toBe(whole);
  await page.locator('.replay .player canvas').hover({ position: { x: 30, y: 200 } });
  expect(await page.locator('.replay .readout').textContent()).toMatch(
    /^\(0,\d+\): \d visits?, \d+ steps to the goal$/,
  );
});

test.each(proof ? [1280, 390] : [390])('a name of any length stays in its place: %i pixels', async (width) => {
  const long = (name: string) => {
    const file = temporary('long.jsonl');
    native('run', 'flood', 'capstone-1', '--record', file);
    return readFileSync(file, 'utf8').replace('"flood"', `"${name.repeat(100)}"`);
  };
  const page = await open('#replay', { viewport: { width, height: 800 } });
  await drop(page, { name: 'a.jsonl', content: long('nobody') }, { name: 'b.jsonl', content: long('others') });
  await replayed(page, 'nobody');
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
  const numbers = await page.locator('.replay .facts').evaluate((facts) => [facts.scrollWidth, facts.clientWidth]);
  expect(numbers[0]).toBeLessThanOrEqual(numbers[1]);
  // How it ended is not cut off with it.
  const beyond = await page.locator('.replay figcaption h3').evaluateAll((heads) =>
    heads.map((head) => {
      const outcome = document.createRange();
      outcome.selectNodeContents(head.lastChild!);
      return outcome.getBoundingClientRect().right - head.getBoundingClientRect().right;
    }),
  );
  expect(Math.max(...beyond)).toBeLessThan(1);
  await picture(page, `replay-long-names-${width}`);
});

test('a picture of the record is saved', async () => {
  const page = await opened();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Save whole walk (SVG)' }).click(),
  ]);
  expect(download.suggestedFilename()).toBe('ariadne-capstone-1.svg');
  expect(readFileSync((await download.path())!, 'utf8')).toContain('<svg');
});
