// Chromium on the built page, from the disk, as a user opens it.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import axe from 'axe-core';
import { chromium, type Browser, type BrowserContextOptions, type Page, type ViewportSize } from 'playwright-core';
import { expect, inject } from 'vitest';

export const root = resolve(__dirname, '../../../../..');
export const builtPage = join(root, 'build/page/labmouse.html');
export const program = process.env.LABMOUSE_PROGRAM ?? join(root, 'build/release/labmouse');
/** The folder of mazes that lies beside the checkout on some machines; null on others. */
export const manyMazes = existsSync(join(root, '../shared/mazes/classic'))
  ? join(root, '../shared/mazes/classic')
  : null;

/** Whether all cases are asked for, as by `make proof`; otherwise those that take long are left out. */
export const proof = process.env.LABMOUSE_PROOF !== undefined;

/** Of views that look the same but for their colours, one is enough. */
export const themes: ('light' | 'dark')[] = proof ? ['light', 'dark'] : ['dark'];

/** Runs the native program and returns what it prints. */
export function native(...words: string[]): string {
  return execFileSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 28 });
}

let browser: Promise<Browser> | null = null;

/** A page of a test, and under which options it may serve another one; null where no other may have it. */
interface Lent {
  page: Page;
  options: string | null;
}
const lent: Lent[] = [];
/** Pages that no test has: a new one costs a process, most of what opening takes. */
const spare: Lent[] = [];
const mostSpare = 4;
/** What the pages of a test said to the console that they should not have, and what they asked of a network. */
const complaints: string[] = [];

/** The one browser of all tests, which ends with them; each test has pages of its own in it. */
function theBrowser(): Promise<Browser> {
  browser ??= chromium.launch({
    // Without the windows of Chromium, which take a quarter of the processor time of these tests.
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell',
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

/** Leads nowhere, with nothing kept and no way back. */
async function cleaned({ page }: Lent) {
  await page.goto('about:blank');
  const client = await page.context().newCDPSession(page);
  await client.send('Storage.clearDataForOrigin', { origin: 'file://', storageTypes: 'all' });
  await client.send('Page.resetNavigationHistory');
  await client.detach();
}

/** Takes the pages of a test back, and fails where they complained. */
export async function endOfTest() {
  for (const one of lent.splice(0)) {
    if (one.options === null || one.page.isClosed()) await one.page.context().close();
    else {
      await cleaned(one);
      spare.push(one);
      if (spare.length > mostSpare) await spare.shift()!.page.context().close();
    }
  }
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

/** Opens the page, or another file such as a report, in a browser that knows nothing of others, until its frame stands. */
export async function open(hash = '', { file = builtPage, before, ...options }: Opening = {}) {
  const { page } = await lend(options, before);
  await page.goto(pathToFileURL(file).href + hash);
  await page.getByRole('navigation', { name: 'Views' }).waitFor();
  return page;
}

async function lend(options: BrowserContextOptions, before: Opening['before']): Promise<Lent> {
  const { colorScheme = 'light', reducedMotion = 'no-preference', viewport, ...others } = options;
  const size = viewport ?? { width: 1280, height: 900 };
  const key = before ? null : JSON.stringify(others);
  const found = spare.findIndex((one) => one.options === key);
  const one =
    key !== null && found >= 0 ? spare.splice(found, 1)[0] : { page: await newPage(others, size), options: key };
  lent.push(one);
  await one.page.setViewportSize(size);
  await one.page.emulateMedia({ colorScheme, reducedMotion, media: null });
  await before?.(one.page);
  return one;
}

async function newPage(options: BrowserContextOptions, viewport: ViewportSize): Promise<Page> {
  const context = await (await theBrowser()).newContext({ viewport, acceptDownloads: true, ...options });
  const page = await context.newPage();
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('request', (request) => {
    if (/^https?:/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
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

/** Waits until the replay shows that: part of what stands above the picture. */
export const replayed = (page: Page, text: string) =>
  page.locator('.replay figcaption', { hasText: text }).first().waitFor();

/** Chooses a contest at the side of the replay, and waits until it is shown. */
export async function choose(page: Page, mice: string[], maze: string, world?: string): Promise<void> {
  const choices = page.locator('.replay .choices');
  const captions = page.locator('.replay figcaption');
  await captions.first().waitFor();
  if ((await choices.getAttribute('open')) === null) await choices.locator('summary').click();
  const select = (label: string, value: string) => choices.getByLabel(label, { exact: true }).selectOption(value);
  if (world) await select('World', world);
  await select('Maze', maze);
  await select('Mouse', mice[0]);
  await select('Beside it', mice[1] ?? '');
  const shown = async () => (await captions.allTextContents()).map((text) => text.split(':', 1)[0].split(',', 1)[0]);
  await expect.poll(shown).toEqual(mice.map((mouse) => `${mouse} in ${maze}`));
  // Each choice plays it anew: what stands there now is that of the last.
  await expect.poll(() => choices.getAttribute('aria-busy')).toBe(null);
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
