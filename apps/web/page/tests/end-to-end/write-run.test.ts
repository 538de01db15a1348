// Programs that run in the view Write: on the leaderboard, as on the command line, in the sandbox, and when they fail.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { barriers, native, open, picture, program, proof, provoked, temporary } from './harness';
import { button, doing, openWrite, run, template, templates, verdict, view, write } from './writing';

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
