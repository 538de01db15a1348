// Firefox on the built page, driven by WebDriver BiDi, which Firefox itself speaks: no driver beside it.
import { mkdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import puppeteer, { type Browser, type Page } from 'puppeteer-core';
import { expect } from 'vitest';
import { builtPage, temporary } from '../end-to-end/harness';

/** Patience with a busy machine, in milliseconds. */
const patience = 120_000;

let browser: Promise<Browser> | null = null;
const pages: Page[] = [];
/** What the pages of a test said to the console that they should not have, and what they asked of a network. */
const complaints: string[] = [];

function theBrowser(): Promise<Browser> {
  // Firefox does not start in the home of another user.
  const home = temporary('firefox');
  mkdirSync(home, { recursive: true });
  browser ??= puppeteer.launch({
    browser: 'firefox',
    executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr',
    env: { ...process.env, HOME: home },
    timeout: patience,
    protocolTimeout: patience,
  });
  return browser;
}

/** Opens the page from the disk, and waits until its frame stands. */
export async function open(hash = ''): Promise<Page> {
  const page = await (await theBrowser()).newPage();
  pages.push(page);
  page.setDefaultTimeout(patience);
  await page.setViewport({ width: 1280, height: 900 });
  // Whatever the page's policy holds back is an error, too.
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on('request', (request) => {
    if (/^(https?|wss?):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(builtPage).href + hash);
  await page.waitForSelector('nav[aria-label=Views]');
  return page;
}

/** Closes the pages of a test, and fails where they complained. */
export async function endOfTest() {
  for (const page of pages.splice(0)) await page.close();
  expect(complaints.splice(0)).toEqual([]);
}

/** Takes out what was complained of. */
export const complained = () => complaints.splice(0);

export async function endOfTests() {
  await (await browser)?.close();
  browser = null;
}
