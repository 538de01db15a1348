// The view Write: from a starting point to one's own mouse on the leaderboard, and what a program cannot do.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, drop, native, open, picture, program, proof, provoked, root, temporary } from './harness';

const templates = join(root, 'apps/web/page/src/write/javascript/templates');
const template = (name: string) => readFileSync(join(templates, `${name}.js`), 'utf8');

const view = (page: Page) => page.getByRole('region', { name: 'Write', exact: true });
const verdict = (page: Page) => view(page).locator('.verdict');
const editor = (page: Page) => view(page).getByRole('textbox', { name: 'The program' });
const button = (page: Page, name: string) => view(page).getByRole('button', { name, exact: true });

async function openWrite(hash = '#write', options = {}) {
  const page = await open(hash, options);
  await editor(page).waitFor();
  return page;
}

/** Replaces what stands in the editor. */
async function write(page: Page, text: string) {
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(text);
}

/** Says its greeting, then does that in its first step. */
const doing = (act: string) => `
require('readline').createInterface({ input: process.stdin }).on('line', async (line) => {
  if (line === 'begin') console.log('labmouse 1');
  if (!line.startsWith('sense')) return;
  ${act}
});
`;

async function run(page: Page, text: string) {
  await write(page, text);
  await button(page, 'Run').click();
  await expect.poll(() => verdict(page).getAttribute('data-state')).toMatch(/good|bad/);
  return (await verdict(page).textContent())!;
}

test('one change, a name, and it stands on the leaderboard', async () => {
  const page = await open('#home');
  await page.getByRole('link', { name: 'Write your own' }).click();
  const changed = template('flood-fill').replace('LONGEST_STEP_OF_SEARCH = 1', 'LONGEST_STEP_OF_SEARCH = 2');
  await write(page, changed);
  await view(page).getByLabel('Name of your mouse').fill('long-legs');
  await view(page)
    .getByText(/^In mazes/)
    .click();
  const mazes = view(page).getByRole('group', { name: 'In mazes' });
  await mazes.getByRole('button', { name: 'None' }).click();
  for (const name of ['capstone-1', 'contest-01', 'contest-05']) await mazes.getByLabel(name, { exact: true }).check();
  await button(page, 'Race').click();
  const board = view(page).getByRole('table', { name: 'Leaderboard' });
  await board.getByText('long-legs').waitFor();
  await picture(page, 'write-race');
  expect(await barriers(page)).toEqual([]);

  const folder = temporary('long-legs');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'mouse.js'), changed);
  const words = [
    'race',
    '--mice',
    'long-legs=program:node mouse.js',
    '--mazes',
    'capstone-1',
    'contest-01',
    'contest-05',
  ];
  const results = JSON.parse(
    execFileSync(program, [...words, '--format', 'json', '--directory', folder], { encoding: 'utf8' }),
  );
  const mean = results.groups[0].mice[0].mean_par1.toFixed(3);
  await page.getByRole('link', { name: 'Race', exact: true }).first().click();
  const race = page.getByRole('region', { name: 'Race' });
  await race.getByText('long-legs').first().waitFor();
  const row = race.getByRole('row').filter({ hasText: 'long-legs' }).first();
  expect(await row.textContent()).toContain(mean);

  // Changed once more, it stands beside what it was; a maze that is new to both is run by both.
  await page.getByRole('link', { name: 'Write', exact: true }).click();
  expect(await board.locator('tr.own').allTextContents()).toEqual([expect.stringMatching(/^long-legs★ yours\d/)]);
  expect(await board.getByText('★ yours').count()).toBe(1);
  // A contest that it lost much in is brought into sight as a whole, and its maze is where it runs next.
  await view(page).getByRole('button', { name: 'contest-05' }).click();
  const header = (await page.getByRole('banner').boundingBox())!;
  const caption = (await view(page).locator('figcaption').boundingBox())!;
  expect(caption.y).toBeGreaterThanOrEqual(header.height);
  expect(await view(page).getByRole('combobox', { name: 'Maze' }).inputValue()).toBe('contest-05');
  await write(page, changed.replace('LONGEST_STEP_OF_SEARCH = 2', 'LONGEST_STEP_OF_SEARCH = 3'));
  await mazes.getByLabel('contest-05', { exact: true }).uncheck();
  await button(page, 'Race').click();
  await expect.poll(() => verdict(page).textContent()).toMatch(/^long-legs is .*; long-legs-before is number \d/);
  const own = () => board.locator('tr.own').allTextContents();
  const ownNames = (await own()).map((text) => /^[a-z-]+[^\d]*/.exec(text)![0]).sort();
  expect(ownNames).toEqual(['long-legs-before☆ yours, before', 'long-legs★ yours']);
  await mazes.getByLabel('contest-05', { exact: true }).check();
  await button(page, 'Race').click();
  await expect.poll(async () => (await own()).find((text) => text.startsWith('long-legs-before'))).toContain(mean);
});

test('records are those of the command line, byte for byte', async () => {
  const page = await openWrite();
  const folder = temporary('same-records');
  mkdirSync(folder, { recursive: true });
  const programs: [name: string, text: string, mazes: string[]][] = [
    ...readdirSync(templates).map((name): [string, string, string[]] => [
      name.replace('.js', ''),
      readFileSync(join(templates, name), 'utf8'),
      proof ? ['capstone-1', 'contest-05'] : ['capstone-1'],
    ]),
    ['invalid-answer', doing(`console.error('a note', [1, 'b'], { c: 3 }); console.log('fly');`), ['contest-01']],
    ['flooded', doing(`console.log('move 0 1\\nmove 0 1');`), ['contest-01']],
  ];
  for (const [name, text, mazes] of programs) {
    writeFileSync(join(folder, 'mouse.js'), text);
    for (const maze of mazes) {
      await view(page).getByRole('combobox', { name: 'Maze' }).selectOption(maze);
      await view(page).getByLabel('Name of your mouse').fill(name);
      await run(page, text);
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        view(page).getByRole('button', { name: 'Save record' }).click(),
      ]);
      const file = join(folder, 'record.jsonl');
      native('run', `${name}=program:node mouse.js`, maze, '--directory', folder, '--record', file);
      expect(readFileSync((await download.path())!, 'utf8'), `${name} in ${maze}`).toBe(readFileSync(file, 'utf8'));
    }
  }
}, 180_000);

/** Ways out of the sandbox; each says by `told` that it leads out. */
const waysOut: Record<string, string> = {
  fetch: `fetch('http://SERVER/').then(told, refused)`,
  'fetch of a file': `fetch('file:///etc/passwd').then(told, refused)`,
  WebSocket: `try { const s = new WebSocket('ws://SERVER/'); s.onopen = told; s.onerror = refused; } catch (e) { refused(e); }`,
  XMLHttpRequest: `try { const r = new XMLHttpRequest(); r.onload = told; r.onerror = refused; r.open('GET', 'http://SERVER/'); r.send(); } catch (e) { refused(e); }`,
  EventSource: `try { const s = new EventSource('http://SERVER/'); s.onopen = told; s.onerror = refused; } catch (e) { refused(e); }`,
  importScripts: `try { importScripts('http://SERVER/a.js'); told(); } catch (e) { refused(e); }`,
  'importScripts of a blob': `try { importScripts(URL.createObjectURL(new Blob(['1']))); told(); } catch (e) { refused(e); }`,
  import: `import('http://SERVER/a.js').then(told, refused)`,
  eval: `try { eval('1'); told(); } catch (e) { refused(e); }`,
  IndexedDB: `try { const r = indexedDB.open('a'); r.onsuccess = told; r.onerror = refused; } catch (e) { refused(e); }`,
  caches: `try { caches.open('a').then(told, refused); } catch (e) { refused(e); }`,
  localStorage: `try { localStorage.setItem('a', 'b'); told(); } catch (e) { refused(e); }`,
  'the parent': `try { parent.document.title; told(); } catch (e) { refused(e); }`,
  'the files of a browser': `try { navigator.storage.getDirectory().then(told, refused); } catch (e) { refused(e); }`,
};

test('a program reaches nothing', async () => {
  let asked = 0;
  // Whoever asks is answered, so that nothing but the sandbox is in the way.
  const server = createServer((_, answer) => {
    asked += 1;
    answer.writeHead(200, { 'access-control-allow-origin': '*', 'content-type': 'text/javascript' }).end('1');
  });
  server.on('upgrade', () => (asked += 1));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const page = await openWrite();
  const here = `127.0.0.1:${(server.address() as AddressInfo).port}`;
  const tries = Object.entries(waysOut).map(
    ([name, act]) =>
      `await new Promise((next) => {
        const told = () => (console.error('told', '${name}'), next()), refused = () => (console.error('refused', '${name}'), next());
        ${act.replace('SERVER', here)}
      });`,
  );
  await run(page, doing(`${tries.join('\n')} console.log('forfeit');`));
  const prints = await view(page).getByRole('region', { name: 'Prints' }).locator('pre').allTextContents();
  server.close();
  expect(asked).toBe(0);
  expect(prints.join('\n').split('\n')).toEqual(Object.keys(waysOut).map((name) => `refused ${name}`));
  expect(await verdict(page).textContent()).toContain('gave up');
  // What the browser refuses it still tells of.
  provoked(/Content Security Policy|Refused|ERR_|violates|asks for/i);
});

// On a busy machine the time for an answer ends before so much is written.
const flooded = /too much written|hung.*silent/;

const failures: [what: string, program: string, outcome: RegExp][] = [
  ['an endless loop', doing('for (;;);'), /hung.*silent/],
  ['silence', doing(''), /hung/],
  ['a line without its end', doing(`process.stdout.write('move 0 1')`), /hung.*'move 0 1' without ending the line/],
  ['prints now and then', doing(`setInterval(() => console.error('soon'), 300);`), /hung.*silent/],
  ['endless prints', doing(`for (;;) console.error('again');`), flooded],
  ['a flood of messages', doing('for (;;) self.postMessage({ kind: "print", text: "" });'), flooded],
  [
    'messages without sense',
    doing(`self.postMessage(null); self.postMessage({ kind: 'reply', lines: [1] }); console.log('forfeit');`),
    /gave up/,
  ],
  ['an end of its own', doing('process.exit(3)'), /ended early.*exit code 3/],
  ['an error', `// one\n// two\n${doing('undefined.x')}`, /ended early.*error in line 7/],
  ['an error in a promise', doing('await null; throw new Error("late")'), /ended early.*late/],
  ['a program that cannot be read', 'const a = ;', /did not start.*line 1.*SyntaxError/],
  ['a module that is not there', `require('net')`, /did not start.*line 1.*'net'/],
];

/** The first waits for its whole patience; the other takes the machine's memory away from the tests beside it. */
const longFailures: typeof failures = [
  ['an endless loop before its first word', 'for (;;);', /did not start.*within 10 s.*loop without an end/],
  [
    'an endless memory',
    doing('const all = []; for (;;) all.push(new Array(1e6).fill(all.length));'),
    /hung|ended early/,
  ],
];

test('its failure is its forfeit, and the page goes on', async () => {
  const page = await openWrite();
  for (const [what, text, outcome] of [...failures, ...(proof ? longFailures : [])])
    expect(await run(page, text), what).toMatch(outcome);
  provoked(/Content Security Policy|Refused|out of memory/i);
  expect(await run(page, template('flood-fill'))).toContain('finished');
}, 120_000);

test('the failing line is marked, and what it printed stands at its step', async () => {
  const page = await openWrite();
  await run(
    page,
    doing(
      `console.error('I see', line);\n  if (line === 'sense 0 11 0') console.log('move 0 1');\n  else undefined.x;`,
    ),
  );
  await view(page).locator('.cm-failed').waitFor();
  expect(await view(page).locator('.cm-failed').textContent()).toContain('undefined.x');
  const prints = view(page).getByRole('region', { name: 'Prints' });
  expect(await prints.getByRole('listitem').count()).toBe(2);
  await prints.getByRole('button', { name: 'step 1' }).click();
  await expect.poll(() => prints.locator('[aria-current]').textContent()).toContain('I see sense 0 11 0');

  // It failed, so there is no score, nor was there one.
  expect(await view(page).locator('.ticker .score').textContent()).toBe('–');

  // A program that cannot start races nowhere, and what was on the stage is of another one; the choice of a maze stays.
  await view(page).getByRole('combobox', { name: 'Maze' }).selectOption('contest-05');
  await run(page, template('flood-fill'));
  await write(page, `${template('flood-fill')}\nconst a = ;`);
  await button(page, 'Race').click();
  await expect.poll(() => verdict(page).textContent()).toMatch(/^my-mouse did not start: error in line \d+/);
  expect(await view(page).locator('.cm-failed').textContent()).toBe('const a = ;');
  expect(await view(page).getByRole('combobox', { name: 'Maze' }).inputValue()).toBe('contest-05');
  expect(await view(page).getByRole('img', { name: 'Maze contest-05' }).count()).toBe(0);
});

test('a program is kept, and comes with a link only after a click', async () => {
  const page = await openWrite('#write', { permissions: ['clipboard-read', 'clipboard-write'] });
  await write(page, `// mine\n${template('empty')}`);
  await view(page).getByLabel('Name of your mouse').fill('kept');
  await button(page, 'Share').click();
  const shown = view(page).getByLabel('A link to this program');
  await expect.poll(() => shown.inputValue()).toContain('#write=');
  const link = await shown.inputValue();
  await page.reload();
  await expect.poll(() => editor(page).textContent()).toContain('// mine');
  expect(await view(page).getByLabel('Name of your mouse').inputValue()).toBe('kept');

  await write(page, `// other\n${template('empty')}`);
  await page.evaluate((hash) => (location.hash = hash), link.slice(link.indexOf('#')));
  await view(page).getByRole('alert').filter({ hasText: 'somebody else' }).waitFor();
  await expect.poll(() => editor(page).textContent()).toContain('// mine');
  expect(await button(page, 'Run').isDisabled()).toBe(true);
  expect(await barriers(page)).toEqual([]);
  await button(page, 'Let it run').click();
  await expect.poll(() => button(page, 'Run').isDisabled()).toBe(false);
  await view(page).getByLabel('Program to begin with').selectOption('What stood here before');
  await expect.poll(() => editor(page).textContent()).toContain('// other');
});

test('what two tabs write is kept, and each says so', async () => {
  const page = await openWrite();
  const second = await page.context().newPage();
  await second.goto(page.url());
  await expect.poll(() => editor(second).count()).toBe(1);
  const says = (tab: Page) => view(tab).locator('.note [role=status]');
  await write(page, `// of the first\n${template('empty')}`);
  await write(second, `// of the second\n${template('empty')}`);
  await expect.poll(() => says(second).textContent()).toContain('Both are kept');
  await expect.poll(() => says(page).textContent()).toContain('Both are kept');
  await second.close();
  await page.reload();
  await expect.poll(() => editor(page).textContent()).toContain('// of the second');
  await view(page).getByLabel('Program to begin with').selectOption('Also kept: my-mouse, JavaScript');
  await expect.poll(() => editor(page).textContent()).toContain('// of the first');
});

test('in a fresh browser nothing runs beside the program of a link, and back to mine shows what mine does', async () => {
  const work = JSON.stringify({ language: 'javascript', name: 'theirs', text: `// theirs\n${template('empty')}` });
  const page = await openWrite(`#write=${deflateRawSync(work).toString('base64url')}`);
  await expect.poll(() => editor(page).textContent()).toContain('// theirs');
  expect(await verdict(page).isVisible()).toBe(false);
  expect(await button(page, 'Run').isDisabled()).toBe(true);
  await button(page, 'Back to mine').click();
  await expect.poll(() => verdict(page).textContent()).toContain('my-mouse in capstone-1: finished');
  expect(await view(page).getByRole('img', { name: 'Maze capstone-1' }).isVisible()).toBe(true);
  expect(new URL(page.url()).hash).toBe('#write');
});

test('another program begins with nothing of the one before', async () => {
  const page = await openWrite();
  const stage = view(page).locator('.player');
  expect(await run(page, `${'//\n'.repeat(150)}${doing('undefined.x')}`)).toContain('error in line');
  await view(page).getByLabel('Language').selectOption('python');
  await expect.poll(() => editor(page).textContent()).toContain('class Robot');
  expect(await editor(page).evaluate((content) => content.parentElement!.scrollTop)).toBe(0);
  await expect.poll(() => verdict(page).textContent(), { timeout: 20_000 }).toContain('finished');
  expect(await stage.isVisible()).toBe(true);
  // What somebody wrote waits to be asked for.
  await view(page).getByLabel('Language').selectOption('javascript');
  await expect.poll(() => editor(page).textContent()).not.toContain('class Robot');
  expect(await verdict(page).isVisible()).toBe(false);
  expect(await stage.isVisible()).toBe(false);
});

test('of a program that does not start only the error is seen, with what it printed', async () => {
  const page = await openWrite();
  const stage = view(page).locator('.player');
  await stage.waitFor();
  const prints = view(page).getByRole('region', { name: 'Prints' });
  expect(await run(page, `console.error('here');\nundefined.x`)).toMatch(/did not start: error in line 2/);
  expect(await stage.isVisible()).toBe(false);
  expect(await prints.locator('pre').allTextContents()).toEqual(['here']);
  expect(await prints.isVisible()).toBe(true);
  expect(await barriers(page)).toEqual([]);
  expect(await run(page, doing(`console.error('there'); console.log('forfeit');`))).toContain('gave up');
  expect(await prints.locator('pre').allTextContents()).toEqual(['there']);
  // Nor does a race leave the stage of the program before.
  await write(page, `console.error('again');\nundefined.x`);
  await button(page, 'Race').click();
  await expect.poll(() => verdict(page).textContent()).toMatch(/did not start/);
  expect(await stage.isVisible()).toBe(false);
});

test('what is stopped says no longer that it runs', async () => {
  const page = await openWrite();
  await write(page, doing('for (;;);'));
  await button(page, 'Run').click();
  await button(page, 'Stop').click();
  expect(await verdict(page).isVisible()).toBe(false);
});

test('a link leads to the maze and the step where one was', async () => {
  const page = await openWrite();
  await drop(page, { name: 'own.txt', content: native('make', 'prim', '--size', '6x6', '--seed', '5') });
  await page.waitForFunction(() => document.title === 'Live · labmouse');
  await page.getByRole('link', { name: 'Write', exact: true }).click();
  await view(page).getByRole('combobox', { name: 'Maze' }).selectOption('own.txt');
  expect(await run(page, `// mine\n${template('flood-fill')}`)).toContain('in own.txt: finished');
  const slider = (of: Page) => view(of).getByRole('slider', { name: 'Moment of the replay' });
  await slider(page).fill('3');
  await button(page, 'Share').click();
  const shown = view(page).getByLabel('A link to this program');
  await expect.poll(() => shown.inputValue()).toMatch(/#write=[\w-]+&maze=1\.[\w.-]+&at=3$/);
  const other = await openWrite(new URL(await shown.inputValue()).hash);
  await expect
    .poll(() => view(other).getByRole('combobox', { name: 'Maze' }).locator('option:checked').textContent())
    .toContain('own.txt · yours');
  expect(await slider(other).isVisible()).toBe(false);
  await button(other, 'Let it run').click();
  await expect.poll(() => slider(other).inputValue()).toBe('3');
  expect(await verdict(other).textContent()).toContain('finished');
  // Another program has no step there.
  await write(other, `// other\n${template('flood-fill')}`);
  await button(other, 'Share').click();
  await expect.poll(() => view(other).getByLabel('A link to this program').inputValue()).toMatch(/&maze=1\.[\w.-]+$/);
  const bad = await openWrite(`${new URL(await shown.inputValue()).hash}&at=4`);
  await bad.getByText('it says at= twice').waitFor();
});

test('letters that one types go to the program, also while a replay stands beside it', async () => {
  const page = await openWrite();
  await expect.poll(() => verdict(page).getAttribute('data-state')).toBe('good');
  await editor(page).click();
  await page.keyboard.press('Control+End');
  const letters = 'abcdefghijklmnopqrstuvwxyz 0123456789 +-=';
  await page.keyboard.type(`\n// ${letters}`);
  expect(await editor(page).locator('.cm-line').last().textContent()).toBe(`// ${letters}`);
});

test('a mouse without a name is asked for one, and a program that is dropped is opened', async () => {
  const page = await openWrite();
  await view(page).getByLabel('Name of your mouse').fill('');
  await button(page, 'Run').click();
  await expect.poll(() => view(page).getByLabel('Name of your mouse').getAttribute('aria-invalid')).toBe('true');
  await drop(page, { name: 'robot.py', content: '# dropped\nclass Robot: pass\n' });
  await expect.poll(() => editor(page).textContent()).toContain('# dropped');
  expect(await view(page).getByLabel('Language').inputValue()).toBe('python');
});

test('a link that is none is told of in words, and what stands there runs', async () => {
  const page = await openWrite('#write=AAAA');
  await page.getByText('does not contain a whole program').waitFor();
  await expect.poll(() => verdict(page).getAttribute('data-state')).toBe('good');
});

test.each([
  ['telephone', { viewport: { width: 390, height: 844 }, colorScheme: 'dark', hasTouch: true }],
  ['window', { viewport: { width: 1440, height: 900 }, colorScheme: 'light' }],
] as const)('nothing bars the way on a %s', async (name, options) => {
  const page = await openWrite('#write', options);
  await run(page, template('flood-and-return'));
  expect(await barriers(page)).toEqual([]);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(options.viewport.width);
  await picture(page, `write-${name}`);
});

test('a run says what the score was before, in the same maze', async () => {
  const page = await openWrite();
  const said = () => verdict(page).textContent();
  await expect.poll(said).toContain('finished, score');
  const [, before] = /score (\d+\.\d{3});/.exec((await said())!)!;
  await write(page, template('flood-fill').replace('LONGEST_STEP_OF_SEARCH = 1', 'LONGEST_STEP_OF_SEARCH = 3'));
  await button(page, 'Run').click();
  await expect.poll(said).toContain(`, before ${before}; best possible`);
  await view(page).getByRole('combobox', { name: 'Maze' }).selectOption('contest-05');
  await button(page, 'Run').click();
  await expect.poll(said).toMatch(/in contest-05: finished, score \d+\.\d{3}; best possible/);
});

test('keys run the program and save it as a file, and change nothing in it', async () => {
  const page = await openWrite();
  await expect.poll(() => verdict(page).getAttribute('data-state')).toBe('good');
  await write(page, 'throw Error("here")');
  await page.keyboard.press('Control+Enter');
  await expect.poll(() => verdict(page).textContent()).toContain('here');
  const saved = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  expect((await saved).suggestedFilename()).toBe('mouse.js');
  expect(readFileSync(await (await saved).path(), 'utf8')).toBe('throw Error("here")');
});

test('Tab indents, after Escape it leads out of the editor, and a program to begin with is undone like any change', async () => {
  const page = await openWrite();
  await write(page, 'mine');
  await view(page).getByLabel('Program to begin with').selectOption('Wall follower');
  await expect.poll(() => editor(page).textContent()).toContain('left hand');
  await page.keyboard.press('Control+z');
  await expect.poll(() => editor(page).textContent()).toBe('mine');
  await page.keyboard.press('Control+z');
  expect(await editor(page).textContent()).not.toBe('mine');
  await write(page, 'a');
  await page.keyboard.press('Tab');
  expect(await editor(page).textContent()).toMatch(/^a\s+$/);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  expect(await page.evaluate(() => document.activeElement?.className)).not.toContain('editor');
});
