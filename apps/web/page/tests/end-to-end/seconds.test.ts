// Contests in seconds, in Replay and in Live.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, choose, drop, native, open, picture, proof, temporary } from './harness';

/** Drives the example, with its maze. */
async function driven(options = {}) {
  const page = await open('#replay', options);
  await choose(page, ['certify'], 'contest-01', 'seconds');
  return page;
}

const moment = async (page: Page) => (await page.locator('.replay .moment').textContent())!;
const clock = async (page: Page) => Number(/ at ([\d.]+) of/.exec(await moment(page))![1]);
const end = async (page: Page) => Number(/ of ([\d.]+) s/.exec(await moment(page))![1]);
const scrubber = (page: Page) => page.getByRole('slider', { name: 'Moment of the replay' });
/** A slider writes a number without zeros at its end. */
const scrub = (page: Page, time: number) => scrubber(page).fill(String(Number(time.toFixed(3))));
const fact = async (page: Page, name: string) =>
  page
    .locator('.replay .facts tr', { has: page.getByRole('rowheader', { name, exact: true }) })
    .locator('td')
    .first()
    .textContent();
const pixels = (page: Page) =>
  page.locator('.replay .sides canvas').evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
const speedRun = (page: Page) =>
  page
    .locator('.replay .drive-runs')
    .getByRole('button', { name: /speed run$/ })
    .last();

test('a contest in seconds is played on its clock, move by move', async () => {
  const page = await driven();
  expect(await moment(page)).toContain('certify at 0.000 of');
  expect(await moment(page)).toContain('search: at (0,0) north, 0.00 m/s');
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => clock(page)).toBeGreaterThan(0);
  const first = await clock(page);
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => clock(page)).toBe(0);
  await scrub(page, first / 2);
  await expect.poll(() => clock(page)).toBeCloseTo(first / 2, 2);
  await page.keyboard.press('End');
  await expect.poll(() => moment(page)).toContain('finished');
  expect(await clock(page)).toBe(await end(page));
  expect(await fact(page, 'best so far')).toBe(await fact(page, 'score'));
});

test('its runs are listed, and lead to their beginnings, with their curves', async () => {
  const page = await driven();
  const runs = page.locator('.replay .drive-runs tbody tr');
  expect(await runs.allTextContents()).toEqual([
    expect.stringContaining('1 search'),
    expect.stringContaining('2 way home'),
    expect.stringContaining('3 speed run'),
  ]);
  expect(await runs.last().textContent()).toContain('best');
  await speedRun(page).click();
  await expect.poll(() => fact(page, 'run')).toBe('speed run');
  expect(await runs.last().getAttribute('aria-current')).toBe('true');
  expect(await fact(page, 'time in this run')).toBe('0.000 s');
  const curves = page.locator('.replay .drive-curves');
  await curves.locator('canvas').waitFor();
  expect(await curves.getByRole('img').getAttribute('aria-label')).toMatch(/run 3: speed run; at most [\d.]+ m\/s/);
  const before = await pixels(page);
  await curves.locator('.u-over').click({ position: { x: 150, y: 20 } });
  await expect.poll(() => fact(page, 'time in this run')).not.toBe('0.000 s');
  await expect.poll(() => pixels(page)).not.toBe(before);
  expect(await curves.locator('.reading').textContent()).toMatch(/^[\d.]+ s: [\d.]+ m\/s, −?[\d.]+ m\/s²$/);
});

test('it runs in real time and slower', async () => {
  const page = await driven();
  const speed = page.getByRole('combobox', { name: /^Speed/ });
  await speed.selectOption('0.1×');
  await expect.poll(() => page.locator('.replay .rate').textContent()).toBe('0.1 s/s');
  await speed.selectOption('64×');
  await page.keyboard.press('Space');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await expect.poll(() => moment(page)).toContain('finished');
});

test('what was scrubbed is drawn the same forwards and backwards, in each layer', async () => {
  const page = await driven();
  const whole = await end(page);
  const at = async (time: number) => {
    await scrub(page, time);
    await expect.poll(() => clock(page)).toBeCloseTo(time, 2);
    return pixels(page);
  };
  const first = await at(whole / 3);
  const later = await at(whole - 1.234);
  expect(first).not.toBe(later);
  expect(await at(whole / 3)).toBe(first);
  expect(await at(whole - 1.234)).toBe(later);
  expect(await page.locator('.replay .legend').textContent()).toContain('m/s, in steps of');
  let before = later;
  for (const key of ['1', '2', '3', '4', '7', '8']) {
    await page.keyboard.press(key);
    await expect.poll(() => pixels(page), { message: key }).not.toBe(before);
    before = await pixels(page);
  }
});

test('its record and its picture are saved, and the record is opened again', async () => {
  const page = await driven();
  const whole = await moment(page);
  const saved = async (button: string) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: button }).click(),
    ]);
    return { name: download.suggestedFilename(), content: readFileSync((await download.path())!, 'utf8') };
  };
  const drawing = await saved('Save whole walk (SVG)');
  expect(drawing.name).toBe('certify-contest-01.svg');
  expect(drawing.content).toContain('<title>certify in contest-01: ');
  const record = await saved('Save record');
  expect(record.name).toBe('certify-contest-01.jsonl');
  await choose(page, ['ariadne'], 'contest-02', 'seconds');
  await drop(page, record);
  await expect.poll(() => moment(page)).toBe(whole);
  await drop(page, { name: 'changed.jsonl', content: record.content.replace(/"gate_out":\d/, '"gate_out":9') });
  await expect.poll(() => page.locator('.alerts').textContent()).toContain('recorded as leaving the start at');
});

test('a record of the physical world shows the true mouse and the one that it thinks it is', async () => {
  const folder = temporary('slips');
  native(
    ...[
      'race',
      '--world',
      'physical',
      '--mice',
      'flood-return',
      '--mazes',
      'contest-05',
      '--runs',
      '1',
      '--variation',
      'practice',
    ],
    ...['--out', folder, '--overwrite'],
  );
  const page = await open('#replay');
  const [name] = readdirSync(join(folder, 'flood-return')).filter((file) => file.endsWith('.jsonl'));
  await drop(page, { name, content: readFileSync(join(folder, 'flood-return', name)) });
  await expect.poll(() => moment(page)).toContain('flood-return at 0.000 of');
  const half = (await end(page)) / 2;
  await scrub(page, half);
  await expect.poll(() => clock(page)).toBeCloseTo(half, 2);
  const layer = page.locator('.replay').getByRole('checkbox', { name: 'Beams and beliefs' });
  expect(await layer.isChecked()).toBe(true);
  const both = await pixels(page);
  await layer.uncheck();
  await expect.poll(() => pixels(page)).not.toBe(both);
  await layer.check();
  await expect.poll(() => pixels(page)).toBe(both);
});

test.runIf(proof)('nothing is in the way of anybody, in light and dark, at every width', async () => {
  const page = await driven();
  await speedRun(page).click();
  await scrub(page, (await end(page)) - 2);
  await page.keyboard.press('8');
  await expect.poll(() => fact(page, 'run')).toBe('speed run');
  for (const colorScheme of ['light', 'dark'] as const)
    for (const width of [1280, 390]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: width === 1280 ? 1000 : 844 });
      if ((colorScheme === 'light') === (width === 1280)) expect(await barriers(page)).toEqual([]);
      await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
      await picture(page, `seconds-${colorScheme}-${width}`);
      await page.locator('.replay .drive-curves').scrollIntoViewIfNeeded();
      if (width === 390) await picture(page, `seconds-${colorScheme}-${width}-curves`);
    }
  await page.emulateMedia({ colorScheme: 'light' });
  await page.setViewportSize({ width: 1280, height: 1230 });
  await page.evaluate(() => scrollTo(0, 0));
  const mark = page.locator('.replay .drive-curves .now');
  const place = () => mark.evaluate((element) => new DOMMatrix(getComputedStyle(element).transform).e);
  await expect.poll(place).toBeGreaterThan(50);
  await picture(page, 'seconds');
});

test('a mouse drives in Live, with a robot and rules, and the address says so', async () => {
  const page = await open('#live');
  const live = page.getByRole('region', { name: 'Live' });
  const outcome = live.locator('.verdict');
  await expect.poll(() => outcome.textContent()).toContain('score');
  await live.getByLabel('World').selectOption('seconds');
  await expect.poll(() => outcome.textContent()).toMatch(/finished, score [\d.]+ s, best possible [\d.]+ s$/);
  await live.getByRole('combobox', { name: 'Robot', exact: true }).selectOption('half');
  await live.getByLabel('Rules').selectOption('thirtieth');
  await page.getByRole('region', { name: 'Mouse' }).getByLabel('Name').selectOption('certify');
  await expect.poll(() => page.evaluate(() => location.hash)).toMatch(/mouse=certify.*&robot=half&rules=thirtieth$/);
  await expect.poll(() => outcome.textContent()).toMatch(/^certify in .* finished, score/);
  const said = await outcome.textContent();
  expect(await barriers(page)).toEqual([]);
  await page.reload();
  await expect.poll(() => outcome.textContent()).toBe(said);
  await page.getByRole('region', { name: 'Mouse' }).getByLabel('Name').selectOption('random');
  await expect.poll(() => outcome.textContent()).toContain("mouse 'random' cannot drive");
});

/** How many pixels of the maze have the tone in which what is wrong is painted. */
const wrongPixels = (page: Page) =>
  page.locator('.replay .sides canvas').evaluate((canvas: HTMLCanvasElement) => {
    const sample = document.body.appendChild(document.createElement('i'));
    sample.style.color = 'var(--wrong)';
    const probe = document.createElement('canvas').getContext('2d', { willReadFrequently: true })!;
    probe.fillStyle = getComputedStyle(sample).color;
    sample.remove();
    probe.fillRect(0, 0, 1, 1);
    const tone = new Uint32Array(probe.getImageData(0, 0, 1, 1).data.buffer)[0];
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(canvas, 0, 0);
    const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
    return pixels.filter((pixel) => pixel === tone).length;
  });

test('belief and truth part in a contest that is prepared, and come together again', async () => {
  const page = await open('#replay');
  const choices = page.locator('.replay .choices');
  await choices.waitFor();
  if ((await choices.getAttribute('open')) === null) await choices.locator('summary').click();
  await page.getByRole('button', { name: /belief and truth part/ }).click();
  // It begins 2 s before the first false wall.
  await expect.poll(async () => ((await moment(page)).includes('festina') ? clock(page) : 0)).toBeGreaterThan(0);
  const begin = await clock(page);
  const rows = page.locator('.replay .drive-runs tbody tr');
  expect(await rows.count()).toBeGreaterThan(4);
  expect(await page.locator('.replay .signs').allTextContents()).toEqual(
    expect.arrayContaining([expect.stringContaining('there is no wall, but the mouse has read one')]),
  );
  // What it reads about a cell has that tone, too.
  await page.getByRole('checkbox', { name: 'Beams and beliefs' }).uncheck();
  await expect.poll(() => wrongPixels(page)).toBe(0);
  await scrub(page, begin + 2.5);
  await expect.poll(() => wrongPixels(page)).toBeGreaterThan(20);
  await page.keyboard.press('End');
  await expect.poll(() => wrongPixels(page)).toBe(0);
  await expect.poll(() => moment(page)).toContain('finished');
});

test('a contest of the physical world is chosen like any other', async () => {
  const page = await open('#replay');
  await choose(page, ['certify', 'festina'], 'contest-02', 'physical');
  expect(await moment(page)).toContain('certify at 0.000 of');
  expect(await page.getByRole('checkbox', { name: 'Beams and beliefs' }).isChecked()).toBe(true);
});
