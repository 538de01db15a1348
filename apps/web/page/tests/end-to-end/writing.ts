// What tests of the view Write share: its parts, and programs to write into it.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect } from 'vitest';
import { open, root } from './harness';

export const templates = join(root, 'apps/web/page/src/write/javascript/templates');
export const template = (name: string) => readFileSync(join(templates, `${name}.js`), 'utf8');

export const view = (page: Page) => page.getByRole('region', { name: 'Write', exact: true });
export const verdict = (page: Page) => view(page).locator('.verdict');
export const editor = (page: Page) => view(page).getByRole('textbox', { name: 'The program' });
export const button = (page: Page, name: string) => view(page).getByRole('button', { name, exact: true });

export async function openWrite(hash = '#write', options = {}) {
  const page = await open(hash, options);
  await editor(page).waitFor();
  return page;
}

/** Replaces what stands in the editor. */
export async function write(page: Page, text: string) {
  await editor(page).focus();
  await page.keyboard.press('Control+A');
  await page.keyboard.press('Delete');
  await page.keyboard.insertText(text);
}

/** Says its greeting, then does that in its first step. */
export const doing = (act: string) => `
require('readline').createInterface({ input: process.stdin }).on('line', async (line) => {
  if (line === 'begin') console.log('labmouse 1');
  if (!line.startsWith('sense')) return;
  ${act}
});
`;

export async function run(page: Page, text: string) {
  await write(page, text);
  await button(page, 'Run').click();
  await expect.poll(() => verdict(page).getAttribute('data-state')).toMatch(/good|bad/);
  return (await verdict(page).textContent())!;
}
