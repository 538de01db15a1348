// The built file, without a browser: what it weighs, and whose work is inside.
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, expect, test } from 'vitest';
import { pythonSize, size, wholeSize } from '../../bench/size';
import { coreLicences, licenceOf } from '../../build/notices';

const page = resolve(__dirname, '../..');
const file = resolve(page, '../../../build/page/labmouse.html');

test('the page is one file of at most 1.8 megabytes without Python', () => {
  expect(pythonSize()).toBeGreaterThan(0.1);
  expect(wholeSize()).toBeGreaterThan(pythonSize());
  expect(size()).toBeLessThanOrEqual(1.8);
});

test('the licence of each library is inside', () => {
  const text = readFileSync(file, 'utf8');
  const notices = text.slice(text.indexOf('<!-- This page contains libraries of others.'));
  const { dependencies } = JSON.parse(readFileSync(join(page, 'package.json'), 'utf8'));
  for (const name of Object.keys(dependencies)) {
    expect(notices).toMatch(new RegExp(`^(.*, )?${name}(,.*)?$`, 'm'));
    expect(notices).toContain(licenceOf(join(page, 'node_modules', name), name));
  }
  expect(notices).toContain(coreLicences());
});

const musl = '/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT';

test.skipIf(!existsSync(musl))('the licence of musl is that of the compiler that is here', () => {
  expect(coreLicences()).toContain(readFileSync(musl, 'utf8').trim().replaceAll('--', '- -'));
});

const folder = mkdtempSync(join(tmpdir(), 'labmouse-licences-'));
afterAll(() => rmSync(folder, { recursive: true }));

test('a library without the text of its licence is refused, and so is another version of one that was looked at', () => {
  const micropython = '@micropython/micropython-webassembly-pyscript';
  const write = (version: string, license: string) =>
    writeFileSync(join(folder, 'package.json'), JSON.stringify({ version, license }));
  write('1.0.0', 'MIT');
  expect(() => licenceOf(folder, 'other')).toThrow('no text');
  expect(() => licenceOf(folder, micropython)).toThrow('1.0.0');
  const { version } = JSON.parse(readFileSync(join(page, 'node_modules', micropython, 'package.json'), 'utf8'));
  write(version, 'GPL');
  expect(() => licenceOf(folder, micropython)).toThrow('GPL');
  write(version, 'MIT');
  expect(licenceOf(folder, micropython)).toContain('MIT License');
  writeFileSync(join(folder, 'LICENSE'), 'the text');
  expect(licenceOf(folder, 'other')).toBe('the text');
  expect(() => licenceOf(folder, micropython)).toThrow('by now');
});
