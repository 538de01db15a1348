// A report of a race that was really held, and all sorts of files dropped on it.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, test } from 'vitest';
import type { ContestResult, RaceResults } from '../../src/core/types';
import { builtPage, drop, manyMazes, native, open, picture, proof, root, temporary } from './harness';

/** For mms: it draws, and runs into a wall. */
const painter = `
import sys
for line in ("setColor 0 0 G", "setColor 0 1 r", "setText 0 1 hello", "setWall 0 0 e"):
    print(line, flush=True)
for _ in range(3):
    print("moveForward", flush=True)
    if input() == "crash": break
`;

const some = (folder: string, pattern: RegExp) =>
  readdirSync(folder)
    .filter((name) => pattern.test(name))
    .map((name) => join(folder, name));

/** A race in those mazes: its results, and its report. */
function hold(mazes: string[]) {
  const [folder, report, guest] = [temporary('race'), temporary('race.html'), temporary('painter.py')];
  writeFileSync(guest, painter);
  const mice = ['ariadne,certify,flood,wall-left,visit-counter', `mms:python3 ${guest}`];
  native(
    'race',
    ...mice.flatMap((mouse) => ['--mice', mouse]),
    '--world',
    'each',
    '--mazes',
    ...mazes,
    '--runs',
    '2',
    '--out',
    folder,
  );
  native('report', folder, '-o', report, '--page', builtPage);
  const text = readFileSync(join(folder, 'results.json'), 'utf8');
  return { report, text, results: JSON.parse(text) as RaceResults, mazes };
}

const leaderboard = (page: Page, name = 'Leaderboard') => page.getByRole('region', { name: `${name}, table` });
const matrix = (page: Page, at = 0) => page.getByRole('application').nth(at);
const alert = (page: Page) => page.getByRole('alert').filter({ hasText: /./ }).first();
const replay = (page: Page) => page.getByRole('region', { name: 'Replay', exact: true });
const draw = (page: Page) => page.getByRole('region', { name: 'Draw', exact: true });
const score = (page: Page) =>
  replay(page)
    .locator('.facts tr', { has: page.getByRole('rowheader', { name: 'score', exact: true }) })
    .locator('td')
    .first()
    .textContent();

async function opened(report: string) {
  const page = await open('', { file: report });
  await matrix(page).waitFor();
  return page;
}

/** Leads the mouse to that cell of the only row that is left, and clicks. */
async function clickCell(page: Page, mouse: string, column: number, board = 0) {
  await page.getByLabel('Search mice by name').fill(mouse);
  const cells = matrix(page, board);
  await cells.focus();
  await page.keyboard.press('Home');
  for (let i = 0; i < column; ++i) await page.keyboard.press('ArrowRight');
  // Where it is on the board: pictures above that come later move it in the window.
  const position = await cells.locator('.mark').evaluate((mark: HTMLElement) => ({
    x: mark.offsetLeft + mark.offsetWidth / 2,
    y: mark.offsetTop + mark.offsetHeight / 2,
  }));
  await cells.click({ position });
}

const stem = (path: string) => path.replace(/^.*\//, '').replace(/\.\w+$/, '');
/** The mazes in the order of the columns. */
const columns = (results: RaceResults) =>
  [...results.groups[0].mazes].sort((a, b) => stem(a.name).localeCompare(stem(b.name), 'en', { numeric: true }));
const contests = (results: RaceResults, mouse: string, maze: string): ContestResult[] =>
  results.groups[0].mice.find(({ name }) => name === mouse)!.results.filter((contest) => contest.maze === maze);

const race = hold(
  manyMazes
    ? some(manyMazes, proof ? /^alljapan-0/ : /^alljapan-0[01]/)
    : some(join(root, 'mazes'), /^contest-[01][0-9]\.txt$/),
);

describe(`a race in ${race.mazes.length} mazes`, () => {
  test('has its results in the table', async () => {
    const page = await opened(race.report);
    const rows = await leaderboard(page).locator('tbody tr').all();
    const shown = await Promise.all(rows.map((row) => row.locator('th .name, td').allTextContents()));
    const digits = (value: number | null, count: number) => (value === null ? '–' : value.toFixed(count));
    expect(
      shown.map(([name, finished, all, , ratio, finishedMean]) => [name, finished, all, ratio, finishedMean]),
    ).toEqual(
      race.results.groups[0].mice.map((mouse) => [
        mouse.name,
        `${mouse.finished} of ${mouse.runs}`,
        ...[mouse.mean_par1, mouse.mean_ratio, mouse.mean_score].map((mean) => digits(mean as number | null, 3)),
      ]),
    );
    expect(await leaderboard(page, 'Leaderboard, mms').locator('tbody tr').count()).toBe(1);
  });

  test('has a record behind each cell', async () => {
    const page = await opened(race.report);
    for (const [mouse, column, run] of [
      ['certify', 2, 0],
      ['visit-counter', 4, 1],
      ['ariadne', 0, 0],
    ] as const) {
      await page.getByRole('link', { name: 'Race' }).click();
      await clickCell(page, mouse, column);
      const maze = columns(race.results)[column];
      const alike = contests(race.results, mouse, maze.name);
      if (alike.length > 1) await page.locator('.runs button').nth(run).click();
      await page.waitForFunction(() => document.title === 'Replay · labmouse');
      await expect.poll(() => replay(page).locator('.moment').textContent()).toContain(`${mouse} after 0 of`);
      await page.keyboard.press('End');
      const { score: expected } = alike[run];
      expect(await score(page)).toBe(expected === null ? '–' : Number(expected).toFixed(3));
    }
    // The last was ariadne, which says why.
    await page.keyboard.press('Home');
    await page.keyboard.press('ArrowRight');
    await replay(page).locator('.reasons .chosen').first().waitFor();
    await picture(page, 'report-replay');
  });

  test('compares two mice as the program does', async () => {
    const old = temporary('flood.json');
    writeFileSync(old, native('race', '--mice', 'flood', '--mazes', ...race.mazes, '--format', 'json'));
    const told = native('race', '--mice', 'ariadne', '--mazes', ...race.mazes, '--baseline', old);
    const line =
      /ariadne against flood: (\S+) \[(\S+), (\S+)\] over (\d+) mazes \((\d+) better, (\d+) equal, (\d+) worse\): (.+)/;
    const [, mean, low, high, count, below, equal, above, verdict] = line.exec(told)!;

    const page = await opened(race.report);
    const words = page.locator('.words').first();
    await page.getByLabel('First').first().selectOption('ariadne');
    await page.getByLabel('second').first().selectOption('flood');
    await expect.poll(() => words.textContent()).toMatch(/^ariadne against flood/);
    expect((await words.textContent())!.replaceAll('−', '-')).toContain(
      `${mean} steps on average (95 % interval ${low} to ${high}) over ${count} mazes: ${verdict}. ` +
        `Lower in ${below}, equal in ${equal}, higher in ${above}`,
    );
    await page
      .getByRole('region', { name: 'Differences, maze by maze' })
      .first()
      .getByRole('button', { name: stem(race.mazes[1]) })
      .click();
    await expect.poll(() => replay(page).locator('.moment').textContent()).toContain('flood after 0 of');
    await picture(page, 'report-two');
  });

  test('shows a program for mms with what it drew', async () => {
    const page = await opened(race.report);
    await clickCell(page, 'painter', 1, 1);
    const canvas = replay(page).locator('.player canvas').first();
    await canvas.waitFor();
    const pixels = () => canvas.evaluate((element: HTMLCanvasElement) => element.toDataURL());
    const drawn = replay(page).getByLabel('Drawn by the program');
    const before = await pixels();
    await drawn.uncheck();
    await expect.poll(pixels).not.toBe(before);
  });
});

test('a race in seconds replays its records', async () => {
  const [folder, report] = [temporary('drives'), temporary('drives.html')];
  native('race', '--world', 'seconds', '--mice', 'flood,ariadne', '--mazes', 'contest-05', '--out', folder);
  native('report', folder, '-o', report, '--page', builtPage);
  const page = await opened(report);
  expect(await leaderboard(page, 'Leaderboard, seconds').locator('tbody tr').count()).toBe(2);
  await matrix(page).focus();
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
  expect(await page.getByRole('status').first().textContent()).not.toContain('behaves differently');
});

test('a report of a single contest opens in the player, and a link into it where that leads', async () => {
  const [folder, report] = [temporary('single'), temporary('single.html')];
  native('race', '--mice', 'flood', '--mazes', 'contest-05', '--out', folder);
  native('report', folder, '-o', report, '--page', builtPage);
  const page = await open('', { file: report });
  await page.waitForFunction(() => document.title === 'Replay · labmouse');
  const [{ mice }] = (JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8')) as RaceResults).groups;
  expect(Number(await score(page))).toBeCloseTo(Number(mice[0].results[0].score), 3);
  const linked = await open('#race', { file: report });
  await leaderboard(linked).waitFor();
  expect(await linked.title()).toBe('Race · labmouse');
});

describe('files and links', () => {
  test('dropped results are a race; what they lack can be dropped, too', async () => {
    const strange = temporary('strange.txt');
    native('make', 'contest', '--seed', '99', '-o', strange);
    const results = native('race', '--mice', 'flood,certify', '--mazes', strange, '--format', 'json');
    const page = await open('#draw');
    await page.getByRole('application', { name: /^Drawing of/ }).waitFor();
    await drop(page, { name: 'results.json', content: results });
    await leaderboard(page).waitFor();
    await clickCell(page, 'flood', 0);
    await expect
      .poll(() => alert(page).textContent())
      .toContain('The maze strange is not in this page. Drop its file here');
    await drop(page, { name: 'strange.txt', content: readFileSync(strange) });
    await page.waitForFunction(() => document.title === 'Live · labmouse');
    await page.goBack();
    await matrix(page).click({ position: { x: 3, y: 3 }, trial: true });
    await clickCell(page, 'flood', 0);
    await replay(page).locator('.player canvas').waitFor();
    const [
      {
        results: [contest],
      },
    ] = (JSON.parse(results) as RaceResults).groups[0].mice.filter(({ name }) => name === 'flood');
    expect(await score(page)).toBe(Number(contest.score).toFixed(3));
  });

  test('a maze of any format opens in Live', async () => {
    const page = await open('#race');
    for (const format of ['drawing', 'capstone', 'num', 'maz']) {
      const file = temporary(`of-${format}`);
      native('convert', 'contest-03', file, '--format', format);
      await drop(page, { name: `of-${format}`, content: readFileSync(file) });
      await page.getByRole('region', { name: 'Live' }).getByText(`ariadne in of-${format}: finished`).waitFor();
    }
    const made = /score ([\d.]+)/.exec(native('run', 'ariadne', 'contest-03'))![1];
    expect(await page.getByRole('region', { name: 'Live' }).locator('.verdict').textContent()).toContain(
      `score ${made}`,
    );
  });

  test('what is wrong is said with its place; nothing breaks, and nothing is lost', async () => {
    const record = temporary('whole.jsonl');
    native('run', 'flood', 'contest-01', '--record', record);
    const [header, ...lines] = readFileSync(record, 'utf8').split('\n');
    const { maze, ...bare } = JSON.parse(header);
    const wrongMaze = { ...maze, drawing: [...maze.drawing].reverse() };
    const [{ mice, ...group }] = race.results.groups;
    const groups = [{ ...group, mice: mice.map(({ runs: _, ...mouse }) => mouse) }];
    const older = { ...race.results, labmouse: '0.0.1', groups };
    const hostile: [string, string | Buffer, RegExp][] = [
      ['broken.txt', 'o---o---o\n|     | |\no   o---o\n|       |\no---o---o\n', /broken\.txt.*line 2, column 7: /s],
      ['bare.jsonl', [JSON.stringify(bare), ...lines].join('\n'), /bare\.jsonl.*maze/s],
      [
        'unfit.jsonl',
        [JSON.stringify({ ...bare, maze: wrongMaze }), ...lines].join('\n'),
        /unfit\.jsonl does not match its maze.*step 1: recorded at/s,
      ],
      ['cut.json', race.text.slice(0, race.text.length / 2), /cut\.json.*line \d+, column \d+/s],
      [
        'older.json',
        JSON.stringify(older),
        /older\.json.*written by labmouse 0\.0\.1.*'groups\[0\]\.mice\[0\]\.runs' is missing/s,
      ],
      [
        'report.html',
        readFileSync(race.report).subarray(0, 50_000),
        /report\.html is a labmouse page; open it in the browser/,
      ],
      ['noise.bin', Buffer.from(Array.from({ length: 300 }, (_, i) => (i * 151) % 256)), /noise\.bin/],
      ['empty', '', /empty is empty/],
    ];

    const page = await open('#draw', { file: race.report });
    const board = page.getByRole('application', { name: /^Drawing of/ });
    await board.waitFor();
    await draw(page).getByLabel('Name').fill('my maze');
    await board.focus();
    const verdict = () => page.getByRole('region', { name: 'Judgement' }).getByRole('status').textContent();
    await expect.poll(verdict).not.toBe('');
    for (const key of ['w', 'd']) await page.keyboard.press(key);
    const before = 'No goal can be reached from the start.';
    await expect.poll(verdict).toBe(before);
    await page.getByRole('link', { name: 'Race' }).click();
    const rows = await leaderboard(page).textContent();
    for (const [name, content, message] of hostile) {
      await drop(page, { name, content });
      await expect.poll(() => alert(page).textContent(), { message: name }).toMatch(message);
      expect([name, await page.title(), await leaderboard(page).isVisible()]).toEqual([name, 'Race · labmouse', true]);
      await alert(page).getByRole('button', { name: 'Dismiss' }).first().click();
    }
    expect(await leaderboard(page).textContent()).toBe(rows);
    await page.evaluate(() => (location.hash = 'maze=16.16.abc'));
    await expect.poll(() => alert(page).textContent()).toMatch(/link/);
    await board.waitFor();
    expect(await verdict()).toBe(before);
    expect(await draw(page).getByLabel('Name').inputValue()).toBe('my maze');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect.poll(verdict).not.toBe(before);
  });

  test('a record without a maze plays in the maze at hand', async () => {
    const [file, maze] = [temporary('robot.jsonl'), temporary('contest-01.txt')];
    native('run', 'flood', 'contest-01', '--record', file);
    native('convert', 'contest-01', maze);
    const [header, ...lines] = readFileSync(file, 'utf8').split('\n');
    const bare = JSON.stringify({ ...JSON.parse(header), maze: undefined });
    const page = await open('#race');
    await drop(page, { name: 'contest-01.txt', content: readFileSync(maze) });
    await page.getByRole('region', { name: 'Live' }).getByText('ariadne in contest-01.txt: finished').waitFor();
    await drop(page, { name: 'robot.jsonl', content: [bare, ...lines].join('\n') });
    await page.getByRole('button', { name: 'Play it in the maze of Live' }).click();
    await replay(page).locator('.player canvas').waitFor();
    await page.keyboard.press('End');
    expect(await score(page)).toBe(JSON.parse(lines.filter(Boolean).at(-1)!).score.toFixed(3));
  });

  test('a report that was cut shows what is left of it', async () => {
    const whole = readFileSync(race.report, 'utf8');
    const records = whole.indexOf('id="labmouse-records"');
    const cut = (name: string, at: number) => (writeFileSync(temporary(name), whole.slice(0, at)), temporary(name));
    const end = whole.indexOf('</script>', records);
    const page = await open('', { file: cut('few.html', (records + end) / 2) });
    await leaderboard(page).waitFor();
    await clickCell(page, 'ariadne', 0);
    await expect
      .poll(() => alert(page).textContent())
      .toContain('The records in this page cannot be read: the file is incomplete');
    await replay(page).locator('.player canvas').waitFor();

    const block = whole.indexOf('id="labmouse-report"');
    const other = await open('', { file: cut('none.html', (block + records) / 2) });
    await expect
      .poll(() => alert(other).textContent())
      .toContain('The report in this page cannot be read: the file is incomplete');
    await other.getByRole('button', { name: 'Start the race' }).waitFor();
  });
});
