// Chromium on the built page, from the disk, as a user opens it.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import axe from 'axe-core';
import { chromium, type Browser, type BrowserContextOptions, type Page } from 'playwright-core';
import { expect, inject } from 'vitest';

export const root = resolve(__dirname, '../../../../..');
export const builtPage = join(root, 'build/page/labmouse.html');
export const program = process.env.LABMOUSE_PROGRAM ?? join(root, 'build/release/labmouse');
/** The folder of mazes that lies beside the checkout on some machines; null on others. */
export const manyMazes = existsSync(join(root, '../shared/mazes/classic'))
  ? join(root, '../shared/mazes/classic')
  : null;

/** Runs the native program and returns what it prints. */
export function native(...words: string[]): string {
  return execFileSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 28 });
}

let browser: Promise<Browser> | null = null;
const pages: Page[] = [];
/** What the pages of a test said to the console that they should not have, and what they asked of a network. */
const complaints: string[] = [];

/** The one browser of all tests, which ends with them; each test has pages of its own in it. */
function theBrowser(): Promise<Browser> {
  browser ??= chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
    ],
  });
  return browser;
}

/** Closes the pages of a test, and fails where they complained. */
export async function endOfTest() {
  for (const page of pages.splice(0)) await page.context().close();
  expect(complaints.splice(0)).toEqual([]);
}

/** Takes out the complaints that a test provoked, and returns how many there were. */
export function provoked(pattern: RegExp): number {
  const others = complaints.filter((complaint) => !pattern.test(complaint));
  const count = complaints.length - others.length;
  complaints.splice(0, complaints.length, ...others);
  return count;
}

/** A place for a file of these tests. */
export const temporary = (name: string) => join(inject('folder'), name);

interface Opening extends BrowserContextOptions {
  file?: string;
  /** Done with the page before it is opened. */
  before?: (page: Page) => Promise<unknown>;
}

/** Opens the page, or another file such as a report, and waits until its frame stands. */
export async function open(hash = '', { file = builtPage, before, ...options }: Opening = {}) {
  const context = await (
    await theBrowser()
  ).newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  pages.push(page);
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (/^https?:/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await before?.(page);
  await page.goto(pathToFileURL(file).href + hash);
  await page.getByRole('navigation', { name: 'Views' }).waitFor();
  return page;
}

/** What axe-core finds that is serious or worse, in words. */
export async function barriers(page: Page): Promise<string[]> {
  // Through the debugger, which the page's policy does not hold back.
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() =>
    (window as unknown as { axe: typeof axe }).axe.run(document, { resultTypes: ['violations'] }),
  );
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`);
}

/** Saves a picture for the eye (and for docs/) as build/page/pictures/NAME.png. */
export async function picture(page: Page, name: string): Promise<void> {
  const pictures = join(root, 'build/page/pictures');
  mkdirSync(pictures, { recursive: true });
  await page.screenshot({ path: join(pictures, `${name}.png`), animations: 'disabled' });
}

/** Drops files on the page, as a hand does. */
export async function drop(page: Page, ...files: { name: string; content: string | Buffer }[]): Promise<void> {
  const data = await page.evaluateHandle(
    (list) => {
      const transfer = new DataTransfer();
      for (const { name, bytes } of list) transfer.items.add(new File([new Uint8Array(bytes)], name));
      return transfer;
    },
    files.map(({ name, content }) => ({ name, bytes: [...Buffer.from(content)] })),
  );
  for (const type of ['dragenter', 'dragover', 'drop']) await page.dispatchEvent('body', type, { dataTransfer: data });
}

/** What the browser keeps for the page under that name, as JSON. */
export function keptInBrowser(page: Page, key: string): Promise<string> {
  return page.evaluate(
    (name) =>
      new Promise<string>((resolve, reject) => {
        const asking = indexedDB.open('labmouse');
        asking.onupgradeneeded = () => asking.result.createObjectStore('kept');
        asking.onerror = () => reject(asking.error);
        asking.onsuccess = () => {
          const base = asking.result;
          const end = (value: unknown) => (base.close(), resolve(JSON.stringify(value ?? null)));
          if (!base.objectStoreNames.contains('kept')) return end(null);
          const got = base.transaction('kept').objectStore('kept').get(name);
          got.onsuccess = () => end(got.result?.value);
        };
      }),
    key,
  );
}
