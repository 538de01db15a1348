// Links to moments, and what a reload keeps.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { RaceResults, WorldInPage } from '../../src/core/types';
import { barriers, drop, keptInBrowser, native, open, picture, proof, replayed, root } from './harness';

const tell = (page: Page) => page.locator('.status');

/** What the page copies is kept in `copied`, as a clipboard from the disk cannot be read. */
const withClipboard = {
  before: (page: Page) =>
    page.addInitScript(() =>
      Object.defineProperty(navigator, 'clipboard', {
        value: { writeText: async (text: string) => void Object.assign(window, { copied: text }) },
      }),
    ),
};
const opened = (hash: string, options = {}) => open(hash, { ...withClipboard, ...options });

/** The text behind # of the link of what is seen now. */
async function linkOf(page: Page): Promise<string> {
  await page.evaluate(() => Object.assign(window, { copied: '' }));
  await page.getByRole('button', { name: 'Copy link' }).click();
  const copied = () => page.evaluate(() => (window as unknown as { copied: string }).copied);
  await expect.poll(copied).not.toBe('');
  return `#${(await copied()).split('#')[1]}`;
}

const position = (page: Page) => page.getByRole('region', { name: 'Replay' }).getByRole('slider');
const replayLink = '#replay&mouse=ariadne&mouse=flood&in=contest-02&seed=3&at=40&zoom=2,4,5';

test('a replay of two mice goes into a link and comes back at its moment', async () => {
  const page = await opened(replayLink);
  await expect.poll(() => page.locator('.side').count()).toBe(2);
  await expect.poll(() => position(page).inputValue()).toBe('40');
  const link = await linkOf(page);
  expect(link).toMatch(/^#replay&mouse=ariadne&mouse=flood&in=contest-02&seed=3&at=40&zoom=2,/);
  const other = await opened(link);
  await expect.poll(() => position(other).inputValue()).toBe('40');
  expect(await linkOf(other)).toBe(link);
  // A reload leads to where one has gone since.
  await position(other).fill('55');
  await expect.poll(() => other.url()).toContain('&at=55&');
  await other.reload();
  await expect.poll(() => position(other).inputValue()).toBe('55');
});

test.runIf(proof)('so does a contest in seconds, in a maze of its own', async () => {
  const live = await opened('#live&mouse=certify&in=contest-02&seed=1&robot=classic&rules=all-japan&at=20.5');
  const outcome = (page: Page) => page.locator('.verdict').first();
  await expect.poll(() => outcome(live).textContent()).toContain('certify in contest-02');
  const link = await linkOf(live);
  expect(link).toBe('#live&mouse=certify&in=contest-02&seed=1&robot=classic&rules=all-japan&at=20.5');
  const text = native('make', 'prim', '--size', '6x6', '--seed', '5');
  await drop(live, { name: 'own.txt', content: text });
  await expect.poll(() => outcome(live).textContent()).toContain('certify in own');
  const own = await linkOf(live);
  expect(own).toMatch(/&maze=1\.[\w.-]+&seed=1&robot=classic&rules=all-japan&at=/);
  const other = await opened(own);
  await expect.poll(() => outcome(other).textContent()).toBe(await outcome(live).textContent());
});

test('a race sets its form up, and is held where it is quick', async () => {
  const quick = '#race&mouse=flood&mouse=certify&in=capstone-1,contest-02&seed=5&runs=3';
  const page = await opened(quick);
  await page.getByRole('region', { name: 'Leaderboard', exact: true }).waitFor();
  expect(await linkOf(page)).toBe(quick);
  const long = await opened('#race&mouse=random-move&in=all&seed=1&runs=100');
  await expect.poll(() => tell(long).textContent()).toContain('set up');
  expect(await long.getByRole('spinbutton', { name: 'runs' }).inputValue()).toBe('100');
  expect(await long.getByRole('region', { name: 'Leaderboard', exact: true }).count()).toBe(0);
  expect(await linkOf(long)).toBe('#race&mouse=random-move&in=all&seed=1&runs=100');
});

/** What is set of a world in the link of a test: nothing that is usual there, but its names, for not all can drive in all worlds. */
const unusual = ({ settings }: WorldInPage) =>
  settings.map(({ name, choices, default: usual }): [string, string] => {
    if (name === 'robot' || name === 'failure_rates') return [name, usual];
    return [name, choices?.at(-1) ?? String(name === 'pace' ? 0.5 : 2 * Number(usual))];
  });

test.runIf(proof)(
  'a race of a link is that of the command line, in every other world, with what is set of it',
  async () => {
    const about = await (await opened('#draw')).evaluate(() => window.labmouse.call('about', {}));
    const others = about.worlds.slice(1);
    expect(others.length).toBeGreaterThan(1);
    for (const world of others) {
      const { name, mice, is_stochastic } = world;
      const [first, second] = mice;
      const set = unusual(world);
      const told = set.filter(([key, value]) => value !== world.settings.find((one) => one.name === key)!.default);
      const where =
        name === 'seconds'
          ? set.map((pair) => pair.join('='))
          : [`world=${name}`, ...told.map((pair) => `set=${pair.join('=')}`)];
      const mazes = ['capstone-1', 'contest-02'];
      const link = `#race&mouse=${first}&mouse=${second}&in=${mazes.join()}&seed=5&runs=2&${where.join('&')}`;
      const page = await opened(link);
      // Where there are errors its title says how many.
      const table = page.getByRole('region', {
        name: new RegExp(`^Leaderboard, ${name}(, noise [\\d.]+, variation [\\d.]+)?, table$`),
      });
      await table.waitFor();
      expect(await linkOf(page)).toBe(link);
      const words = [
        '--mice',
        `${first},${second}`,
        '--mazes',
        ...mazes,
        '--seed',
        '5',
        '--runs',
        '2',
        '--world',
        name,
      ];
      const asked = ['race', ...words, ...set.flatMap(([key, value]) => [`--${key}`, value]), '--format'];
      // Notes are of the race as a whole, which the page holds mouse by mouse.
      const groupsIn = (text: string) =>
        (JSON.parse(text) as RaceResults).groups.map(({ notes: _, ...group }) => group);
      const groups = groupsIn(native(...asked, 'json'));
      const saved = page.waitForEvent('download');
      await page.getByRole('button', { name: 'Save results' }).click();
      expect(groupsIn(readFileSync(await (await saved).path(), 'utf8'))).toEqual(groups);

      // A word that the terminal parts into two lines is whole here.
      expect((groups[0].columns as string[]).filter((title) => title.includes('-'))).toEqual([]);

      // The table is that of the terminal: the same mice in the same order, with the same figures.
      const lines = native(...asked, 'table').split('\n');
      const expected = lines.flatMap((line) => {
        const [mouse, finished, ...figures] = line.split(/ +/);
        return mice.includes(mouse)
          ? [[mouse, finished.replace('/', ' of '), figures.find((one) => /\.\d{3}$/.test(one))]]
          : [];
      });
      expect(expected).toHaveLength(2);
      const rows = await table.locator('tbody tr').all();
      const shown = await Promise.all(rows.map((row) => row.locator('th .name, td').allTextContents()));
      expect(shown.map((row) => row.slice(0, 3))).toEqual(expected);

      // Each cell of the matrix has its contests, with their mean.
      const place = groups[0].score as { key: string; inner: string; unit: number };
      const cells = page.getByRole('application');
      await cells.focus();
      for (const [mouse] of shown)
        for (const [column, maze] of mazes.entries()) {
          const results = groups[0].mice.find(({ name }) => name === mouse)!.results.filter((one) => one.maze === maze);
          expect(results).toHaveLength(is_stochastic ? 2 : 1);
          const scores = results.map(
            ({ score }) => (score as unknown as Record<string, number>)[place.inner] * place.unit,
          );
          await cells.press(column === 0 ? 'Home' : 'ArrowRight');
          const caption = page.locator('.caption[aria-live]').first();
          expect(await caption.textContent()).toContain(`${mouse} in ${maze}`);
          const mean = scores.reduce((sum, score) => sum + score, 0) / scores.length;
          expect(await caption.textContent()).toContain(` ${mean.toFixed(3)}; best `);
          if (column === 1) await cells.press('ArrowDown');
        }
      expect(await page.locator('.alert').count()).toBe(0);
    }
  },
);

test('a race of dice that the world throws is long, too, and waits', async () => {
  const link = '#race&mouse=flood&in=capstone-1&seed=1&runs=100&world=physical';
  const page = await opened(link);
  await expect.poll(() => tell(page).textContent()).toContain('set up');
  expect(await linkOf(page)).toBe(link);
  expect(await page.getByRole('region', { name: /^Leaderboard/ }).count()).toBe(0);
});

test.runIf(proof)(
  'an edited robot in another maze goes into a link, and leaves the one that is kept elsewhere alone',
  async () => {
    const view = (page: Page) => page.getByRole('region', { name: 'Robot', exact: true });
    const key = (page: Page, name: string) => view(page).locator(`[data-key="${name}"]`);
    const route = (page: Page) => view(page).getByRole('table', { name: 'The best route' }).locator('td').first();
    const edit = async (page: Page, name: string, acceleration: string) => {
      await expect.poll(() => route(page).textContent()).toMatch(/ s/);
      await view(page).getByLabel('Name').fill(name);
      await key(page, 'curve.lateral_acceleration').fill(acceleration);
      await expect.poll(() => route(page).textContent()).toContain('was');
    };
    const page = await opened('#robot');
    await edit(page, 'swift', '12000');
    const inCapstone = await route(page).textContent();
    await view(page).getByLabel('Built-in maze').selectOption('contest-02');
    await expect.poll(() => route(page).textContent()).not.toBe(inCapstone);
    const time = (await route(page).textContent())!.split(' s')[0];
    const link = await linkOf(page);
    expect(link).toMatch(/^#robot&in=contest-02&robot=swift%0A/);

    const other = await opened('#robot');
    await edit(other, 'own-one', '9000');
    await expect.poll(() => keptInBrowser(other, 'robot')).toContain('own-one');
    await other.evaluate((hash) => (location.hash = hash), link);
    await expect.poll(() => route(other).textContent()).toBe(`${time} s`);
    expect(await view(other).getByLabel('Name').inputValue()).toBe('swift');
    expect(await key(other, 'curve.lateral_acceleration').inputValue()).toBe('12000');
    expect(await view(other).getByLabel('Built-in maze').inputValue()).toBe('contest-02');
    expect(await linkOf(other)).toBe(link);
    expect(await keptInBrowser(other, 'robot')).toContain('own-one');
    // So it does where the page begins with it.
    const fresh = await opened(link);
    await expect.poll(() => route(fresh).textContent()).toBe(`${time} s`);
    expect(await view(fresh).getByLabel('Name').inputValue()).toBe('swift');
    await key(fresh, 'curve.lateral_acceleration').fill('12001');
    await expect.poll(() => keptInBrowser(fresh, 'robot')).toContain('12001');
    expect(new URL(fresh.url()).hash).toBe('#robot');

    // What is refused has no link; a robot that the page brings is named.
    await key(fresh, 'clearance').fill('70');
    await expect.poll(() => view(fresh).locator('.verdict').getAttribute('data-state')).toBe('bad');
    await fresh.getByRole('button', { name: 'Copy link' }).click();
    await fresh.locator('.alert').waitFor();
    await view(fresh).getByRole('combobox', { name: 'Start from' }).selectOption('half');
    await expect.poll(() => view(fresh).locator('.verdict').getAttribute('data-state')).toBe('good');
    expect(await linkOf(fresh)).toBe('#robot&in=contest-02&robot=half');
  },
);

test.runIf(proof)('which route wins for which robot goes into a link, and stays over a reload', async () => {
  const view = (page: Page) => page.getByRole('region', { name: 'Robot', exact: true });
  const regions = (page: Page) => page.getByRole('region', { name: 'Which route wins', exact: true });
  const table = (page: Page) => regions(page).getByRole('table', { name: 'Which route wins' });
  const rows = (page: Page) => table(page).locator('tbody').textContent();
  const question = 'vary=curve.lateral_acceleration,4000,16000.5';
  const page = await opened('#robot&in=parallel-8&robot=classic');
  const place = regions(page);
  const find = place.getByRole('button', { name: 'Find which route wins' });
  await view(page)
    .getByRole('img', { name: /best route of parallel-8/ })
    .waitFor();
  await place.getByLabel('Vary: from').fill('4000');
  await place.getByLabel('Vary: to').fill('16000.5');
  await find.click();
  await expect.poll(() => table(page).count()).toBe(1);
  const found = await rows(page);
  const link = await linkOf(page);
  expect(link).toBe(`#robot&in=parallel-8&robot=classic&${question}`);
  const other = await opened(link);
  await expect.poll(() => table(other).count()).toBe(1);
  expect(await rows(other)).toBe(found);
  expect(await linkOf(other)).toBe(link);
  await kept(page, 'robot-at').toContain(question);
  await page.reload();
  await expect.poll(() => table(page).count()).toBe(1);
  expect(await rows(page)).toBe(found);

  // Of two numbers, while they are on their way; what the address led to is no longer shown then.
  await regions(other).getByLabel('and', { exact: true }).selectOption('straight.acceleration');
  await regions(other).getByLabel('and: from').fill('4000');
  await regions(other).getByLabel('and: to').fill('20000');
  await regions(other).getByRole('button', { name: 'Find which route wins' }).click();
  const both = await linkOf(other);
  expect(both).toBe(`${link}&and=straight.acceleration,4000,20000`);
  expect(new URL(other.url()).hash).toBe('#robot');
  await page.evaluate((hash) => (location.hash = hash), both);
  await expect.poll(() => place.getByLabel('and: to').inputValue()).toBe('20000');
  await place.getByText('Planning').waitFor();
  // An edit takes them away, also from the link.
  await page.locator('[data-key="straight.speed"]').fill('2900');
  await place.getByText('another one now').waitFor();
  expect(await linkOf(page)).not.toContain('vary');
});

test('the drawing and the home page have links, too', async () => {
  const draw = await opened('#draw&in=contest-02&zoom=3,8,8');
  await draw.getByRole('heading', { name: /contest-02/ }).waitFor();
  const link = await linkOf(draw);
  expect(link).toMatch(/^#draw&in=contest-02&zoom=3,/);
  // Where nothing moves, it is at that moment and at no later one.
  const home = await opened('#home&pair=2&at=30', { reducedMotion: 'reduce' });
  await expect.poll(() => home.locator('.clock').textContent()).toBe('30.00');
  expect(await linkOf(home)).toBe('#home&pair=2&at=30');
});

const hostile: [hash: string, words: RegExp][] = [
  ['#replay&mouse=flood&in=contest-02&at=1e99', /at=1e99/],
  ['#live&mouse=flood&evil=1', /'evil'/],
  ['#live&mouse=flood&in=nowhere', /nowhere/],
  ['#live&mouse=flood&robot=nobody', /'nobody'/],
  ['#robot&robot=nobody', /'nobody'/],
  ['#robot&vary=nothing,1,2', /'nothing'/],
  ['#robot&and=straight.speed,1,2', /no first/],
  ['#race&mouse=nobody&in=capstone-1', /'nobody'/],
  ['#race&mouse=flood&in=capstone-1&runs=0', /runs=0/],
  ['#draw&maze=cut', /cut|link/],
  ['#home&pair=77', /3 races/],
  ['#<img src=x onerror=alert(1)>', /leads nowhere/],
  ['#live&mouse=flood&in=TOO-LONG', /too long/],
];

test('a hostile link says one line and does no harm', async () => {
  const page = await open('#live');
  const alert = page.locator('.alert');
  for (const [hash, words] of hostile) {
    await page.evaluate((text) => (location.hash = text), hash.replace('TOO-LONG', 'x'.repeat(40_000)));
    await expect
      .poll(() => alert.locator('p').allTextContents(), { message: hash })
      .toEqual([expect.stringMatching(words)]);
    // All goes on.
    await page.getByRole('link', { name: 'Live' }).click();
    await expect.poll(() => page.locator('.verdict').first().textContent()).toContain('score');
    await page.getByRole('button', { name: 'Dismiss' }).click();
  }
  // So does one with which the page is opened.
  const fresh = await open(hostile[1][0]);
  await expect.poll(() => fresh.locator('.alert p').allTextContents()).toEqual([expect.stringMatching(hostile[1][1])]);
});

test('a record that the page cannot run again has no link, and says so', async () => {
  const page = await opened('#replay');
  const record = native('run', 'flood', 'capstone-1', '--record', '-').replaceAll('"flood"', '"program:my-mouse"');
  await drop(page, { name: 'record.jsonl', content: record.slice(record.indexOf('{')) });
  await replayed(page, 'program:my-mouse');
  await page.getByRole('button', { name: 'Copy link' }).click();
  await page
    .getByRole('alert')
    .getByText(/A link cannot hold/)
    .waitFor();
});

const menu = (page: Page) => page.locator('details.menu');
async function withMenu(page: Page, act: (box: ReturnType<typeof menu>) => Promise<void>) {
  await menu(page).locator('summary').click();
  await act(menu(page));
  await page.keyboard.press('Escape');
}

/** Waits until the browser has kept that. */
const kept = (page: Page, key: string) => expect.poll(() => keptInBrowser(page, key));

test('a reload keeps maze, record, moment, results and drawing, until it is switched off', async () => {
  const page = await open('#replay');
  await drop(page, { name: 'mine.txt', content: native('make', 'prim', '--size', '5x5', '--seed', '2') });
  await expect.poll(() => page.locator('.verdict').first().textContent()).toContain('in mine');
  const record = native('run', 'flood', 'capstone-1', '--record', '-');
  await drop(page, { name: 'record.jsonl', content: record.slice(record.indexOf('{')) });
  await replayed(page, 'flood in capstone-1');
  await position(page).fill('12');
  await kept(page, 'moment').toContain('at=12');
  await drop(page, {
    name: 'results.json',
    content: native('race', '--mice', 'flood', '--mazes', 'capstone-1', '--format', 'json'),
  });
  await page.getByRole('region', { name: 'Leaderboard', exact: true }).waitFor();
  await kept(page, 'results').toContain('flood');
  await kept(page, 'mazes').toContain('mine');

  await page.reload();
  await page.getByRole('region', { name: 'Leaderboard', exact: true }).waitFor();
  await page.getByRole('link', { name: 'Replay' }).click();
  await expect.poll(() => position(page).inputValue()).toBe('12');
  await page.getByRole('link', { name: 'Race' }).click();
  await page.getByText('Run another race').click();
  await page.getByText(/^Mazes, /).click();
  expect(await page.getByLabel(/^mine/).count()).toBe(1);

  await withMenu(page, async (box) => {
    await box.getByLabel(/Keep what is open/).uncheck();
    await expect.poll(() => tell(page).textContent()).toContain('gone');
  });
  await kept(page, 'results').toBe('null');
  await page.reload();
  await page.getByRole('link', { name: 'Replay' }).click();
  await replayed(page, 'ariadne in');
  await withMenu(page, async (box) => expect(await box.getByLabel(/Keep what is open/).isChecked()).toBe(false));
});

test('a program that ran is there again, at its step in its maze, and is forgotten with all else', async () => {
  const page = await open('#write');
  const view = page.getByRole('region', { name: 'Write', exact: true });
  const slider = view.getByRole('slider', { name: 'Moment of the replay' });
  await view.getByRole('img', { name: 'Maze capstone-1' }).waitFor();
  await view.getByRole('textbox', { name: 'The program' }).focus();
  await page.keyboard.press('Control+End');
  await page.keyboard.insertText('// mine\n');
  await view.getByRole('combobox', { name: 'Maze' }).selectOption('contest-05');
  await view.getByRole('button', { name: 'Run', exact: true }).click();
  await view.getByRole('img', { name: 'Maze contest-05' }).waitFor();
  await slider.fill('5');
  await kept(page, 'write').toMatch(/mine.*in=contest-05&at=5/);
  await page.reload();
  await view.getByRole('img', { name: 'Maze contest-05' }).waitFor();
  expect(await slider.inputValue()).toBe('5');

  const programs = () => page.evaluate(() => Object.keys(localStorage).filter((key) => /write/.test(key)).length);
  expect(await programs()).toBeGreaterThan(0);
  await withMenu(page, async (box) => box.getByLabel(/Keep what is open/).uncheck());
  await expect.poll(programs).toBe(0);
  await view.getByRole('textbox', { name: 'The program' }).focus();
  await page.keyboard.insertText('// more\n');
  await view.getByText('keeps nothing').waitFor();
  expect(await programs()).toBe(0);
  await page.reload();
  await view.getByRole('img', { name: 'Maze capstone-1' }).waitFor();
});

test('what is kept is read like a file: nonsense is left alone', async () => {
  const page = await open('#race');
  await page.evaluate(
    () =>
      new Promise((done) => {
        const asking = indexedDB.open('labmouse');
        asking.onupgradeneeded = () => asking.result.createObjectStore('kept');
        asking.onsuccess = () => {
          const work = asking.result.transaction('kept', 'readwrite');
          const into = work.objectStore('kept');
          into.put({ version: 1, value: { text: '{"mice":3}', raced: [7] } }, 'results');
          into.put({ version: 1, value: [{ record: '<b>', maze: 3 }, null] }, 'plays');
          into.put({ version: 2, value: '#live&mouse=flood&in=contest-02&seed=1' }, 'live');
          into.put({ version: 1, value: { name: 'x', text: 'cell = 180', origin: { name: 'classic' } } }, 'robot');
          into.put({ version: 1, value: '#robot&in=nowhere' }, 'robot-at');
          into.put({ version: 1, value: { text: 3, at: '#<b>' } }, 'write');
          into.put('drawn', 'drawing');
          into.put({ version: 1, value: 'replay&at=-1' }, 'moment');
          work.oncomplete = () => done((asking.result.close(), null));
        };
      }),
  );
  await page.reload();
  await page.getByRole('link', { name: 'Draw' }).click();
  await page.getByRole('heading', { name: /drawing/ }).waitFor();
  expect(await page.locator('.alert').count()).toBe(0);
  await page.getByRole('link', { name: 'Live' }).click();
  await expect.poll(() => page.locator('.verdict').first().textContent()).toContain('ariadne in capstone-1');
  expect(await page.getByRole('option', { name: /my robot/, includeHidden: true }).allTextContents()).toEqual([]);
});

test('without storage everything works', async () => {
  const page = await open('#draw', {
    before: (fresh) =>
      fresh.addInitScript(() => {
        const refuse = () => {
          throw new DOMException('no', 'SecurityError');
        };
        Object.defineProperty(window, 'indexedDB', { get: refuse });
        Object.defineProperty(window, 'localStorage', { get: refuse });
      }),
  });
  await page.getByRole('heading', { name: /drawing/ }).waitFor();
  await page.getByRole('link', { name: 'Live' }).click();
  await expect.poll(() => page.locator('.verdict').first().textContent()).toContain('score');
  await withMenu(page, async (box) => box.getByRole('button', { name: 'Forget what was kept' }).click());
  expect(await page.locator('.alert').count()).toBe(0);
});

test('on a telephone all tools are in the menu, in reach of a finger', async () => {
  const page = await opened('#race', { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
  await menu(page).locator('summary').click();
  for (const name of ['Open file', 'Copy link', 'Forget what was kept'])
    expect((await menu(page).getByRole('button', { name }).boundingBox())!.height).toBeGreaterThanOrEqual(44);
  await picture(page, 'menu-phone');
  expect(await barriers(page)).toEqual([]);
  expect(await linkOf(page)).toMatch(/^#race/);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
});

const documented =
  readFileSync(join(root, 'docs/reference/page.md'), 'utf8').match(/^#(replay|live|race|robot)&\S+$/gm) ?? [];

test('the links of the documentation lead somewhere', async () => {
  expect(documented.length).toBeGreaterThanOrEqual(4);
  const page = await opened('#draw');
  const there = {
    replay: '.side canvas',
    live: '.verdict[data-state=good]',
    race: '[aria-label^=Leaderboard]',
    robot: '.regions img',
  };
  for (const link of documented) {
    await page.evaluate((hash) => (location.hash = hash), link);
    await page
      .locator(there[/^#(\w+)/.exec(link)![1] as keyof typeof there])
      .first()
      .waitFor();
    expect(await page.locator('.alert').count()).toBe(0);
    // The place of a closer look is a whole number of pixels.
    const upToPlace = (text: string) => text.replace(/&zoom=.*/, '');
    await expect.poll(async () => upToPlace(await linkOf(page))).toBe(upToPlace(link));
  }
});
