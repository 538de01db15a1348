// Chromium on the built page, from the disk, as a user opens it.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import axe from 'axe-core';
import { chromium, type Browser, type BrowserContextOptions, type Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';

export const root = resolve(__dirname, '../../../../..');
export const builtPage = join(root, 'build/page/labmouse.html');
export const program = process.env.LABMOUSE_PROGRAM ?? join(root, 'build/release/labmouse');
/** The folder of mazes that lies beside the checkout on some machines; null on others. */
export const manyMazes = existsSync(join(root, '../shared/mazes/classic')) ? join(root, '../shared/mazes/classic') : null;

/** Runs the native program and returns what it prints. */
export function native(...words: string[]): string {
  return execFileSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 28 });
}

let browser: Browser;
const pages: Page[] = [];
/** What the pages of a test said to the console that they should not have, and what they asked of a network. */
const complaints: string[] = [];
let folder: string;

beforeAll(async () => {
  browser = await chromium.launch({
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
  folder = mkdtempSync(join(tmpdir(), 'labmouse-'));
});
afterAll(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true, force: true });
});
afterEach(async () => {
  for (const page of pages.splice(0)) await page.context().close();
  expect(complaints.splice(0)).toEqual([]);
});

/** Takes out the complaints that a test provoked, and returns how many there were. */
export function provoked(pattern: RegExp): number {
  const others = complaints.filter((complaint) => !pattern.test(complaint));
  const count = complaints.length - others.length;
  complaints.splice(0, complaints.length, ...others);
  return count;
}

/** A place for a file of this test program. */
export const temporary = (name: string) => join(folder, name);

/** Opens the page, or another file such as a report, and waits until its core has started. */
export async function open(hash = '', { file = builtPage, ...options }: BrowserContextOptions & { file?: string } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  pages.push(page);
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (/^https?:/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href + hash);
  await page.getByRole('navigation', { name: 'Views' }).waitFor();
  return page;
}

/** What axe-core finds that is serious or worse, in words. */
export async function barriers(page: Page): Promise<string[]> {
  // Through the debugger, which the page's policy does not hold back.
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => (window as unknown as { axe: typeof axe }).axe.run(document));
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
