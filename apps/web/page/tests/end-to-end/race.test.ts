import { readFileSync, writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { Comparison, RaceResults } from '../../src/core/types';
import { barriers, builtPage, drop, native, open, picture, proof, temporary } from './harness';

const pack = (json: unknown) => gzipSync(JSON.stringify(json)).toString('base64');

/** A report page that carries that text as its block. */
function withBlock(name: string, text: string): string {
  const block = `<script type="text/plain" id="labmouse-report">${text}</script>`;
  writeFileSync(
    temporary(name),
    readFileSync(builtPage, 'utf8').replace('<!-- labmouse:report -->', () => block),
  );
  return temporary(name);
}

const results = JSON.parse(
  native('race', '--mice', 'flood,certify,cautious,oracle', '--runs', '3', '--format', 'json'),
) as RaceResults;
const [group] = results.groups;
const report = { labmouse: 'report', format: 2, version: results.labmouse, results, mazes: {} };

const leaderboard = (page: Page) => page.getByRole('region', { name: 'Leaderboard, table' });
const mice = (page: Page) => leaderboard(page).locator('tbody tr:visible th .name').allTextContents();

test('the views are left and found again by links, by the address and by the way back', async () => {
  const page = await open('#race');
  const current = () => page.locator('nav [aria-current=page]').textContent();
  expect([await current(), await page.title()]).toEqual(['Race', 'Race · labmouse']);
  await page.getByRole('link', { name: 'Draw' }).click();
  await page.waitForFunction(() => document.title === 'Draw · labmouse');
  await page.goBack();
  await page.waitForFunction(() => document.title === 'Race · labmouse');
  expect(await current()).toBe('Race');
  const other = await open('#live');
  expect(await other.title()).toBe('Live · labmouse');
});

test('a replay is shown from its top, and the way back leads to where one was', async () => {
  const page = await open('', { file: withBlock('report.html', pack(report)) });
  const scrolled = () => page.evaluate(() => Math.round(scrollY));
  await page.getByRole('region', { name: 'Differences, maze by maze' }).locator('button.link').first().click();
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
  expect(await scrolled()).toBe(0);
  await page.goBack();
  await page.waitForFunction(() => document.title === 'Race · labmouse');
  const below = await scrolled();
  expect(below).toBeGreaterThan(500);
  await page.evaluate(() => scrollTo(0, 300));
  await page.getByRole('link', { name: 'Draw' }).click();
  await page.waitForFunction(() => document.title === 'Draw · labmouse');
  expect(await scrolled()).toBe(0);
  await page.getByRole('link', { name: 'Race' }).click();
  await page.waitForFunction(() => document.title === 'Race · labmouse');
  expect(await scrolled()).toBe(300);
  // Nor do keys that lead to what stands in the header.
  await page.keyboard.press('Shift+Tab');
  expect(await scrolled()).toBe(300);
});

test('the theme is chosen, and kept', async () => {
  const page = await open('#race');
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  expect(await ground()).toBe('rgb(255, 255, 255)');
  await page.getByLabel('Theme').selectOption('dark');
  expect(await ground()).toBe('rgb(20, 24, 29)');
  await page.reload();
  expect(await page.getByLabel('Theme').inputValue()).toBe('dark');
});

test('a small race is held at once, with its best mouse on the stage, and a race of the user takes its place', async () => {
  const page = await open('#race');
  const view = page.getByRole('region', { name: 'Race', exact: true });
  await leaderboard(page).waitFor();
  const [best] = await mice(page);
  await view.locator('.on-stage', { hasText: best }).waitFor();
  const [first] = (await view.getByRole('img', { name: /^Maze / }).getAttribute('aria-label'))!.split(',');
  expect(first).toMatch(/^Maze contest-01/);
  expect(await view.locator('.note.facts').textContent()).toContain('An example');
  await view.getByText(/^Mazes, 43 of/).click();
  const mazes = view.getByRole('group', { name: 'Mazes', exact: true });
  await mazes.getByRole('button', { name: 'None' }).click();
  await mazes.getByLabel('contest-05').check();
  await view.getByRole('button', { name: 'Start the race' }).click();
  await view.getByRole('img', { name: 'Maze contest-05' }).waitFor();
  expect(await view.locator('.note.facts').textContent()).not.toContain('An example');
});

test('no race is held where one was asked for, or the view is not seen', async () => {
  const calls = async (hash: string) => {
    const page = await open(hash, {
      before: (one) =>
        one.addInitScript(() => {
          const said: string[] = [];
          Object.assign(window, { said });
          const send = Worker.prototype.postMessage as (message: unknown, ...more: unknown[]) => void;
          Worker.prototype.postMessage = function (this: Worker, message: unknown, ...more: unknown[]) {
            said.push(JSON.stringify(message) ?? '');
            return send.call(this, message, ...more);
          } as typeof Worker.prototype.postMessage;
        }),
    });
    return page;
  };
  const races = (page: Page) =>
    page.evaluate(() => (window as unknown as { said: string[] }).said.filter((one) => /"race"/.test(one)).length);
  const linked = await calls('#race&mouse=random-move&in=all&seed=1&runs=100');
  await linked.getByText('The race of this link is set up').waitFor();
  expect(await races(linked)).toBe(0);
  const replay = await calls('#replay');
  await replay.locator('.replay .stage canvas').waitFor();
  expect(await races(replay)).toBe(0);
  await replay.getByRole('link', { name: 'Race', exact: true }).click();
  await leaderboard(replay).waitFor();
  expect(await races(replay)).toBeGreaterThan(0);
});

test('a race is held in the page', async () => {
  const page = await open('#race');
  await page.getByRole('button', { name: 'Start the race' }).click();
  await page.getByRole('status').getByText('The race is over: 5 mice, 43 mazes.').waitFor();
  expect(await mice(page)).toHaveLength(5);
});

test('mice are compared until it is decided, as on the command line', async () => {
  const said = native('compare', 'flood', 'certify', '--generator', 'prim', '--size', '6', '--format', 'json');
  const [candidate] = (JSON.parse(said) as Comparison).candidates;
  const page = await open('#race');
  await page.getByText('Compare mice until it is decided').click();
  const form = page.locator('form.compare');
  await form.getByLabel('Kind').selectOption('prim');
  for (const side of ['Width', 'Height']) await form.getByLabel(side).fill('6');
  await form.getByRole('button', { name: 'Compare' }).click();
  await form.getByRole('button', { name: 'Stop' }).waitFor();
  await form.getByRole('button', { name: 'Stop' }).waitFor({ state: 'detached', timeout: 60_000 });
  const cells = page.getByRole('region', { name: 'Verdicts' }).locator('tbody tr > *');
  const [mouse, mazes, share, first, difference, , verdict] = await cells.allTextContents();
  expect([mouse, mazes, verdict]).toEqual(['certify', String(candidate.pairs), candidate.verdict]);
  expect([share, first]).toEqual([candidate.share, candidate.first_share].map((one) => one.toFixed(3)));
  expect(Number(difference)).toBeCloseTo(candidate.difference, 4);
});

test('a race that ends leaves its user in the view where they are, and offers to show it', async () => {
  const page = await open('#race');
  // Where the header has little room.
  await page.setViewportSize({ width: 1024, height: 700 });
  await page.getByRole('button', { name: 'Start the race' }).click();
  await page.getByRole('link', { name: 'Draw' }).click();
  const status = page.getByRole('status').first();
  await status.getByText('The race is over').waitFor();
  expect(await page.title()).toBe('Draw · labmouse');
  await status.getByRole('button', { name: 'Show it' }).click();
  await leaderboard(page).waitFor();
  expect([await page.title(), await page.evaluate(() => location.hash)]).toEqual(['Race · labmouse', '#race']);
});

test('a race in seconds is held, and its contests are driven again', async () => {
  const page = await open('#race');
  await page.getByRole('button', { name: 'Start the race' }).waitFor();
  await page.getByRole('region', { name: 'Race', exact: true }).getByLabel('World').selectOption('seconds');
  const mazes = page.getByRole('group', { name: 'Mazes', exact: true });
  await page.getByText(/^Mazes, 43 of/).click();
  await mazes.getByRole('button', { name: 'None' }).click();
  await mazes.getByLabel('contest-05').check();
  await page.getByRole('button', { name: 'Start the race' }).click();
  const table = page.getByRole('region', { name: 'Leaderboard, seconds, table' });
  await table.waitFor();
  const names = await table.locator('tbody tr:visible th .name').allTextContents();
  expect([...names].sort()).toEqual(['ariadne', 'certify', 'flood', 'flood-return']);
  await page.getByRole('application').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
  expect(await page.getByRole('status').first().textContent()).not.toContain('behaves differently');
});

test('results of a race in seconds are shown', async () => {
  const page = await open('#race');
  const results = ['race', '--world', 'seconds', '--mice', 'flood,ariadne', '--mazes', 'contest-05', 'contest-06'];
  await drop(page, { name: 'seconds.json', content: native(...results, '--format', 'json') });
  const table = page.getByRole('region', { name: 'Leaderboard, seconds, table' });
  await table.waitFor();
  expect(await table.locator('tbody tr:visible th .name').allTextContents()).toEqual(['ariadne', 'flood']);
  expect(await page.getByText('Distributions, seconds').count()).toBe(1);
});

test('a maze that was opened can race, and is replayed as it was', async () => {
  const page = await open('#race');
  await page.getByRole('button', { name: 'Start the race' }).waitFor();
  const maze = { name: 'my-maze.txt', content: native('convert', 'contest-half-01', '-') };
  await drop(page, maze);
  await page.waitForFunction(() => document.title === 'Live · labmouse');
  await page.getByRole('link', { name: 'Race' }).click();
  const mazes = page.getByRole('group', { name: 'Mazes', exact: true });
  await page.getByText(/^Mazes, 43 of/).click();
  await mazes.getByRole('button', { name: 'None' }).click();
  await mazes.getByLabel('my-maze').first().check();
  await page.getByRole('button', { name: 'Start the race' }).click();
  await leaderboard(page).waitFor();
  await page.getByRole('application').focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
});

test('the table of a report is sorted, searched, and marks references', async () => {
  const page = await open('', { file: withBlock('report.html', pack(report)) });
  await leaderboard(page).waitFor();
  expect(await mice(page)).toEqual(['oraclereference', 'certify', 'flood', 'cautious'].sort(byMean));
  // A reference is a line like all others.
  const heights = await leaderboard(page)
    .locator('tbody tr')
    .evaluateAll((rows) => rows.map((row) => Math.round(row.getBoundingClientRect().height)));
  expect(Math.max(...heights)).toBeLessThan(Math.min(...heights) + 3);
  await leaderboard(page).getByRole('button', { name: 'mouse' }).click();
  expect(await mice(page)).toEqual(['cautious', 'certify', 'flood', 'oraclereference']);
  expect(await leaderboard(page).locator('[aria-sort]').getAttribute('aria-sort')).toBe('ascending');
  await page.getByLabel('Search mice by name').fill('FLO');
  expect(await mice(page)).toEqual(['flood']);
});

/** The order in which the results have their mice. */
function byMean(a: string, b: string) {
  const place = (name: string) => group.mice.findIndex((mouse) => name.startsWith(mouse.name));
  return place(a) - place(b);
}

test('a report is found again after other results', async () => {
  const page = await open('', { file: withBlock('report.html', pack(report)) });
  const back = page.getByRole('button', { name: 'Back to the report' });
  await leaderboard(page).waitFor();
  expect(await back.count()).toBe(0);
  const fewer = { ...results, groups: [{ ...group, mice: group.mice.slice(0, 2) }] };
  await drop(page, { name: 'results.json', content: JSON.stringify(fewer) });
  await back.click();
  await page.waitForFunction(() => document.querySelectorAll('.race table.sorted tbody th .name').length >= 4);
  expect(await mice(page)).toEqual(group.mice.map(({ name, contestant }) => (contestant ? name : `${name}reference`)));
  expect(await back.count()).toBe(0);
});

test('what stands below the table of a race is told below the leaderboard', async () => {
  const notes = ['Score: low is good.', '  <b>odd</b> line'];
  const noted = { ...report, results: { ...results, groups: [{ ...group, notes }] } };
  const page = await open('', { file: withBlock('noted.html', pack(noted)) });
  const text = await page.locator('.lines').textContent();
  expect(text!.split('\n')).toEqual(notes);
});

test('the matrix is walked by keys, and tells what it shows', async () => {
  const page = await open('', { file: withBlock('report.html', pack(report)) });
  const cells = page.getByRole('application');
  await cells.focus();
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowDown');
  const [, second] = group.mice;
  const last = [...group.mazes]
    .map(({ name }) => name)
    .sort((a, b) => a.localeCompare(b, 'en', { numeric: true }))
    .at(-1);
  expect(await page.locator('.reading .caption').textContent()).toContain(`${second.name} in ${last} (`);
});

test('several runs of one cell are chosen from a list', async () => {
  const page = await open('', { file: withBlock('report.html', pack(report)) });
  await page.getByLabel('Search mice by name').fill('cautious');
  await page.getByRole('application').focus();
  await page.keyboard.press('Enter');
  expect(await page.locator('.runs button').count()).toBe(3);
  await page.keyboard.press('Escape');
  expect(await page.locator('.runs').isVisible()).toBe(false);
  expect(await page.getByRole('application').evaluate((cells) => cells === document.activeElement)).toBe(true);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
});

test.runIf(proof)(
  'a report is without barriers in light and dark, at every width, and no wider than the page',
  async () => {
    const page = await open('', { file: withBlock('report.html', pack(report)) });
    await page.getByRole('application').waitFor();
    for (const colorScheme of ['light', 'dark'] as const)
      for (const width of [1280, 390]) {
        await page.emulateMedia({ colorScheme });
        await page.setViewportSize({ width, height: 900 });
        if ((colorScheme === 'light') === (width === 1280)) expect(await barriers(page)).toEqual([]);
        await expect
          .poll(() => page.evaluate(() => document.documentElement.scrollWidth - innerWidth))
          .toBeLessThanOrEqual(0);
        await picture(page, `race-${colorScheme}-${width}`);
      }
  },
);

test.each([
  ['cut', pack(report).slice(0, 3000), 'incomplete or damaged'],
  ['of a later format', pack({ ...report, format: 3, version: '9.9' }), 'format 3, made by labmouse 9.9'],
  ['without results', pack({ ...report, results: null }), 'has no results'],
])('a report that is %s is told, and the page goes on', async (_, text, message) => {
  const page = await open('', { file: withBlock('bad.html', text) });
  await page.getByText('Dismiss').waitFor();
  expect(await page.getByRole('alert').textContent()).toContain(message);
  await page.getByRole('button', { name: 'Dismiss' }).click();
  expect(await page.getByRole('alert').textContent()).toBe('');
  await page.getByRole('button', { name: 'Start the race' }).waitFor();
});

test('a link without its maze is told', async () => {
  const page = await open('#maze=');
  await page.getByRole('alert').getByText('This link is incomplete').waitFor();
});

test('of many complaints the newest are shown and the rest counted, until a form is sent again', async () => {
  const page = await open('#race');
  await page.getByRole('button', { name: 'Start the race' }).waitFor();
  await drop(page, ...Array.from({ length: 7 }, (_, i) => ({ name: `bad${i}.txt`, content: 'no maze' })));
  const alert = page.getByRole('alert');
  await alert.getByText('and 3 more').waitFor();
  expect(await alert.getByRole('button', { name: 'Dismiss', exact: true }).count()).toBe(4);
  await picture(page, 'race-complaints');
  await alert.getByRole('button', { name: 'Dismiss', exact: true }).first().click();
  await alert.getByText('and 2 more').waitFor();
  await page.getByRole('link', { name: 'Race' }).click();
  await page.getByRole('button', { name: 'Start the race' }).click();
  await page.waitForFunction(() => document.querySelector('[role=alert]')!.textContent === '');
});

test('names are text, whatever they look like', async () => {
  const name = '<img src=x onerror=alert(1)>';
  const odd = structuredClone(report);
  const { mice: named } = odd.results.groups[0];
  named[1].name = name;
  named[2].results[0].outcome = '<b>bold</b>';
  const page = await open('', { file: withBlock('odd.html', pack(odd)) });
  await page.getByRole('application').waitFor();
  expect(await mice(page)).toContain(name);
  expect(await page.locator('main img, main b').count()).toBe(0);
});

test('a world that the page has never heard of has all pictures of the others', async () => {
  const page = await open('#race');
  const file = new URL('../../../../../tests/toy/results.json', import.meta.url);
  await drop(page, { name: 'toy.json', content: readFileSync(file) });
  const table = page.getByRole('region', { name: 'Leaderboard, toy, table' });
  await table.waitFor();
  expect(await table.locator('tbody tr:visible th .name').count()).toBe(2);
  expect(await table.locator('thead').textContent()).toContain('stumbles a contest');
  await page.getByRole('heading', { name: 'Mice × mazes, toy' }).waitFor();
  await page.getByRole('heading', { name: 'Distributions, toy' }).waitFor();
  await page.getByRole('heading', { name: 'Two mice, toy' }).waitFor();
  const lost = page.getByRole('region', { name: 'Where steps are lost, toy' });
  expect(await lost.textContent()).toContain('This map is drawn of races in steps.');
  await expect
    .poll(() => page.getByRole('region', { name: 'Race', exact: true }).textContent())
    .toMatch(/against .* steps on average/);
  expect(await barriers(page)).toEqual([]);
});
