// The view Robot: numbers of a robot and what follows from them.
import { readFileSync, writeFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, drop, keptInBrowser, native, open, picture, proof, temporary } from './harness';

const view = (page: Page) => page.getByRole('region', { name: 'Robot', exact: true });
const status = (page: Page) => view(page).locator('.verdict').textContent();
const input = (page: Page, key: string) => view(page).locator(`[data-key="${key}"]`);
const errorOf = (page: Page, key: string) =>
  view(page)
    .locator('.field', { has: page.locator(`[data-key="${key}"]`) })
    .locator('.field-error');
const times = (page: Page, turn: string) =>
  view(page).locator(`[data-turn="${turn}"] tbody td:last-child`).allTextContents();
const bestTime = (page: Page) =>
  view(page).getByRole('table', { name: 'The best route' }).locator('td').first().textContent();

async function opened(options = {}) {
  const page = await open('#robot', options);
  await expect.poll(() => bestTime(page)).toMatch(/ s/);
  return page;
}

/** The best time of capstone-1 by the command line. */
function routeTime(robot: string) {
  const { mazes } = JSON.parse(native('route', 'capstone-1', '--robot', robot, '--format', 'json'));
  return (mazes[0].time_us / 1e6).toFixed(3);
}

async function savedFile(page: Page) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    view(page).getByRole('button', { name: 'Save as TOML' }).click(),
  ]);
  return { name: download.suggestedFilename(), content: readFileSync((await download.path())!, 'utf8') };
}

test('what follows from a robot is what the command line says, also after an edit', async () => {
  const page = await opened();
  expect(await status(page)).toBe(/^classic +(.*)$/m.exec(native('robot', 'list'))![1]);
  expect(await bestTime(page)).toBe(`${routeTime('classic')} s`);
  const before = await times(page, '90');
  await input(page, 'curve.lateral_acceleration').fill('12000');
  const was = before.map((time) => expect.stringMatching(new RegExp(`^[\\d.]+ was ${time}$`)));
  await expect.poll(async () => (await times(page, '90')).slice(0, 1)).toEqual(was.slice(0, 1));
  await expect.poll(() => bestTime(page)).toContain('was');
  await picture(page, 'robot');
  expect(await barriers(page)).toEqual([]);
  const saved = await savedFile(page);
  expect(saved.name).toBe('my-mouse.toml');
  const file = temporary('my-mouse.toml');
  writeFileSync(file, saved.content);
  expect(await bestTime(page)).toContain(`${routeTime(file)} s`);
  const shown = native('robot', 'show', file);
  // Three digits each, as there.
  for (const time of await times(page, '90')) expect(shown).toContain(/^\d+\.\d{3}/.exec(time)![0]);
  await view(page).getByRole('button', { name: 'Undo all changes' }).click();
  await expect.poll(() => times(page, '90')).toEqual(before);
});

test('the sensors of a list stay as they are where a number is edited', async () => {
  const page = await opened();
  await view(page).getByRole('combobox', { name: 'Start from' }).selectOption('beginner');
  await input(page, 'straight.speed').fill('900');
  await expect.poll(async () => (await savedFile(page)).content).toContain('speed = 900');
  const file = temporary('listed.toml');
  writeFileSync(file, (await savedFile(page)).content);
  const sensors = (robot: string) =>
    JSON.parse(native('robot', 'show', robot, '--format', 'json')).robot.parameters.infrared;
  expect(sensors(file)).toHaveLength(3);
  expect(sensors(file)).toEqual(sensors('beginner'));
});

const regions = (page: Page) => view(page).getByRole('region', { name: 'Which route wins', exact: true });
const winners = (page: Page) =>
  regions(page)
    .getByRole('table', { name: 'Which route wins' })
    .locator('tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].map(({ textContent }) => textContent)));

test('which route wins for which robot is what the command line says, in words, numbers and picture', async () => {
  const page = await opened();
  await view(page).getByLabel('Name').fill('classic');
  await view(page).getByLabel('Built-in maze').selectOption('contest-01');
  await expect.poll(() => bestTime(page)).toMatch(/ s/);
  await view(page).getByRole('img', { name: 'The best route of contest-01' }).waitFor();
  const place = regions(page);
  await place.getByLabel('Vary', { exact: true }).selectOption('curve.lateral_acceleration');
  await place.getByLabel('Vary: from').fill('4000');
  await place.getByLabel('Vary: to').fill('16000');
  const find = place.getByRole('button', { name: 'Find which route wins' });
  await find.click();
  await place.getByText('2 routes win').waitFor();
  const svg = temporary('regions.svg');
  const words = ['route', 'contest-01', '--vary', 'curve.lateral_acceleration=4000:16000', '--svg', svg];
  const said = JSON.parse(native(...words, '--format', 'json'));
  const saved = async (label: string) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      place.getByRole('button', { name: label }).click(),
    ]);
    return readFileSync((await download.path())!, 'utf8');
  };
  expect(JSON.parse(await saved('Save as JSON'))).toEqual(said);
  expect(await saved('Save diagram (SVG)')).toBe(readFileSync(svg, 'utf8'));
  expect((await winners(page)).map(([route, cells, from, to]) => [route, cells, from, to])).toEqual([
    ['A', '34', '4000', String(Number(said.rows[0].regions[0].to.toPrecision(6)))],
    ['B', '32', String(Number(said.rows[0].regions[1].from.toPrecision(6))), '16000'],
  ]);
  const drawn = place.getByRole('img', { name: /Which route of contest-01 wins for which classic/ });
  expect(await drawn.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBe(1080);
  await drawn.scrollIntoViewIfNeeded();
  await picture(page, 'robot-regions');
  expect(await barriers(page)).toEqual([]);

  // What is wrong stands at its number, and what was found is of no other robot.
  await place.getByLabel('Vary: to').fill('3000');
  await find.click();
  await place.getByText("'vary' needs a range").waitFor();
  expect(await place.getByRole('table').count()).toBe(0);
  await place.getByLabel('Vary: to').fill('16000');
  await find.click();
  await place.getByText('2 routes win').waitFor();
  // It is still there after a look elsewhere.
  await page.getByRole('link', { name: 'Live' }).click();
  await page.getByRole('link', { name: 'Robot' }).click();
  await place.getByText('2 routes win').waitFor();
  await input(page, 'straight.speed').fill('2900');
  await place.getByText('another one now').waitFor();
  expect(await place.getByRole('table').count()).toBe(0);
});

test.runIf(proof)('of two numbers there is a map, a row for each value of the second', async () => {
  const page = await opened();
  const place = regions(page);
  await place.getByLabel('Vary: from').fill('4000');
  await place.getByLabel('Vary: to').fill('16000');
  await place.getByLabel('and', { exact: true }).selectOption('straight.acceleration');
  await place.getByLabel('and: from').fill('4000');
  await place.getByLabel('and: to').fill('20000');
  await place.getByRole('button', { name: 'Find which route wins' }).click();
  await expect.poll(async () => (await winners(page)).length, { timeout: 50_000 }).toBe(33);
  const vary = ['--vary', 'curve.lateral_acceleration=4000:16000', '--and', 'straight.acceleration=4000:20000'];
  const { rows } = JSON.parse(native('route', 'capstone-1', ...vary, '--format', 'json'));
  const [[lowest, routes]] = (await winners(page)).slice(-1);
  expect(lowest).toBe('4000');
  expect(routes!.match(/[A-Z]\d*/g)).toEqual(rows[0].regions.map(({ route }: { route: string }) => route));
});

test('what is wrong stands at its field, and what followed before stays', async () => {
  const page = await opened();
  const time = await bestTime(page);
  await input(page, 'clearance').fill('70');
  await expect.poll(() => errorOf(page, 'clearance').textContent()).toContain('63.6 mm');
  expect(await status(page)).toMatch(/^Refused/);
  expect(await bestTime(page)).toBe(time);
  expect(await view(page).getByRole('button', { name: 'Save as TOML' }).isDisabled()).toBe(true);
  await input(page, 'clearance').fill('');
  await expect.poll(() => errorOf(page, 'clearance').textContent()).toContain('missing');
  await input(page, 'clearance').fill('45');
  await input(page, 'search.pivot_acceleration').fill('17000');
  const remark = view(page)
    .locator('.field', { has: page.locator('[data-key="search.pivot_acceleration"]') })
    .locator('.field-remark');
  await expect.poll(() => remark.textContent()).toContain('degrees');
});

test('published times take the place of limits, and limits that of times', async () => {
  const page = await opened();
  const limits = await bestTime(page);
  const slowest = (await times(page, '90')).at(-1)!;
  const given = (label: string) => view(page).getByLabel(label, { exact: true });
  expect(await given('Turns are given').inputValue()).toBe('limits');
  await given('Turns are given').selectOption('times');
  await expect.poll(() => input(page, 'turns.90').inputValue()).toBe(String(Number(slowest)));
  expect(await input(page, 'turns.speed').inputValue()).toBe('850');
  expect(await input(page, 'curve.lateral_acceleration').count()).toBe(0);
  await expect.poll(() => times(page, '90')).toEqual([expect.stringMatching(new RegExp(`^${slowest} was `))]);
  await given('The search is given').selectOption('times');
  await expect.poll(() => input(page, 'search.cell').inputValue()).toBe('360');
  await input(page, 'turns.90').fill('300');
  await expect.poll(async () => (await times(page, '90'))[0]).toMatch(/^300\.000/);
  const saved = await savedFile(page);
  const file = temporary('times.toml');
  writeFileSync(file, saved.content);
  expect(saved.content).toContain('[turns]');
  expect(await bestTime(page)).toContain(routeTime(file));
  await given('Turns are given').selectOption('limits');
  await given('The search is given').selectOption('limits');
  await expect.poll(() => bestTime(page)).toBe(limits);
  // A robot that began from times takes the limits of one whose cells are as large.
  await view(page).getByRole('combobox', { name: 'Start from' }).selectOption('mm2021');
  await expect.poll(() => given('Turns are given').inputValue()).toBe('times');
  await given('Turns are given').selectOption('limits');
  await expect.poll(() => input(page, 'curve.yaw_acceleration').inputValue()).toBe('300');
  await expect.poll(() => status(page)).toContain('cells of 90 mm');
});

test('an edited robot is there again when the page is opened again, beside what it began from', async () => {
  const page = await opened();
  await view(page).getByLabel('Name').fill('kept-one');
  await input(page, 'curve.lateral_acceleration').fill('12000');
  await expect.poll(() => bestTime(page)).toContain('was');
  const time = await bestTime(page);
  await expect.poll(() => keptInBrowser(page, 'robot')).toContain('12000');
  await page.reload();
  await expect.poll(() => bestTime(page)).toBe(time);
  expect(await view(page).getByLabel('Name').inputValue()).toBe('kept-one');
  expect(await view(page).getByRole('combobox', { name: 'Start from' }).inputValue()).toBe('classic');
  // Elsewhere, too, without a look at this view.
  const live = page.getByRole('region', { name: 'Live' });
  await page.goto(`${page.url().split('#')[0]}#live`);
  await page.reload();
  await live.getByLabel('World').selectOption('seconds');
  await expect
    .poll(() => live.getByRole('combobox', { name: 'Robot', exact: true }).locator('option').allTextContents())
    .toContain('kept-one, my robot');
  await page.getByRole('link', { name: 'Robot' }).click();
  await view(page).getByRole('button', { name: 'Undo all changes' }).click();
  await expect.poll(() => keptInBrowser(page, 'robot')).toBe('null');
});

test('a file is opened by dropping it, and drives in Live under its name', async () => {
  const page = await open('#race');
  await drop(page, { name: 'tank.toml', content: halfWith(900) });
  await expect.poll(() => view(page).getByLabel('Name').inputValue()).toBe('tank');
  await expect.poll(() => input(page, 'straight.speed').inputValue()).toBe('900');
  await input(page, 'straight.speed').fill('1000');
  await expect.poll(() => bestTime(page)).toContain('was');
  await view(page).getByRole('button', { name: 'Drive it in Live' }).click();
  const live = page.getByRole('region', { name: 'Live' });
  await live.getByLabel('World').selectOption('seconds');
  await live.getByRole('combobox', { name: 'Robot', exact: true }).selectOption({ label: 'tank, my robot' });
  await expect.poll(() => live.locator('.verdict').textContent()).toMatch(/score [\d.]+ s/);
  await expect.poll(() => page.url()).toContain('robot=tank%0A');
  const score = await live.locator('.verdict').textContent();
  const other = await open(`#${page.url().split('#')[1]}`);
  await expect.poll(() => other.getByRole('region', { name: 'Live' }).locator('.verdict').textContent()).toBe(score);
});

/** `half` with another top speed. */
const halfWith = (speed: number) =>
  readFileSync(new URL('../../../../../robots/half.toml', import.meta.url), 'utf8').replace(
    /\[straight\]\s*\nspeed = \d+/,
    `[straight]\nspeed = ${speed}`,
  );

test.runIf(proof)('it fits a telephone, in light and dark', async () => {
  for (const colorScheme of ['light', 'dark'] as const) {
    const page = await opened({ viewport: { width: 390, height: 844 }, colorScheme });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await picture(page, `robot-390-${colorScheme}`);
    expect(await barriers(page)).toEqual([]);
  }
});

test('a record of a real mouse is played beside a mouse of ours, up to where they part', async () => {
  const page = await open('#replay');
  await drop(page, { name: 'real.jsonl', content: realRecord() });
  const replay = page.getByRole('region', { name: 'Replay' });
  await replay.getByLabel('Beside it:').selectOption('flood');
  await replay.getByRole('button', { name: 'Play it', exact: true }).click();
  const parting = replay.locator('.parting');
  await expect.poll(() => parting.textContent()).toMatch(/They part at step \d+, in cell \(\d+,\d+\)/);
  expect(await replay.locator('.sides canvas').count()).toBe(2);
  const step = /step (\d+)/.exec((await parting.textContent())!)![1];
  await parting.getByRole('button', { name: 'Go there' }).click();
  await expect
    .poll(() => page.getByRole('slider', { name: 'Moment of the replay' }).inputValue())
    .toBe(String(Number(step) - 1));
});

/** The walk of `certify` as a robot may leave it: actions alone, in a maze that is known. */
function realRecord() {
  const file = temporary('certify.jsonl');
  native('run', 'certify', 'capstone-1', '--record', file);
  const [header, ...lines] = readFileSync(file, 'utf8').trim().split('\n');
  const { maze } = JSON.parse(header);
  const steps = lines.map((line) => JSON.parse(line)).filter(({ action }) => action !== undefined);
  return [{ labmouse: 'record', format: 1, maze }, ...steps.map(({ action }) => ({ action }))]
    .map((line) => JSON.stringify(line))
    .join('\n');
}
