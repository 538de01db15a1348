// The view Write: the editor, what is kept, links and files.
import { readFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, drop, native, picture } from './harness';
import { button, doing, editor, openWrite, run, template, verdict, view, write } from './writing';

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
  // Each tab may have a process of its own, which hears later of what another one has stored.
  await expect.poll(() => second.evaluate(() => Object.values(localStorage).join())).toContain('of the first');
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
