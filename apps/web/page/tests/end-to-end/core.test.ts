import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import type { Core } from '../../src/core/client';
import { native, open, temporary } from './harness';

declare global {
  interface Window {
    labmouse: Core;
  }
}

test('a contest in the browser has the record of the native program', async () => {
  const page = await open('#draw');
  // The header names the version, and the two may have been built at different commits.
  const steps = (record: string) => record.replace(/"version":"[^"]*"/, '"version":""');
  for (const mouse of ['ariadne', 'certify', 'cautious']) {
    const record = await page.evaluate(async (name) => {
      const { maze } = await window.labmouse.call('builtin_maze', { name: 'contest-05' });
      return (await window.labmouse.call('contest', { mouse: name, maze, seed: 7 })).record;
    }, mouse);
    const file = temporary(`${mouse}.jsonl`);
    native('run', mouse, 'contest-05', '--seed', '7', '--explain', '--record', file);
    expect(steps(record)).toBe(steps(readFileSync(file, 'utf8')));
  }
});

test('a core that stops is started again', async () => {
  const page = await open('#draw');
  const strange = { number: 1n } as unknown as Record<string, never>;
  const message = await page.evaluate((request) => window.labmouse.call('about', request).catch(String), strange);
  expect(message).toContain('the core crashed on this request and was restarted');
  expect((await page.evaluate(() => window.labmouse.call('about', {}))).mice.length).toBeGreaterThan(10);
});

test('what the core does not know is refused, and the core goes on', async () => {
  const page = await open('#draw');
  for (const name of ['nothing', 'answer', 'request_bytes']) {
    const message = await page.evaluate((call) => window.labmouse.call(call as 'about', {}).catch(String), name);
    expect(message).toContain(`no call '${name}'`);
  }
});

test('a call is stopped, and those behind it are answered', async () => {
  const page = await open('#draw');
  const ends = await page.evaluate(async () => {
    const { maze } = await window.labmouse.call('make_maze', {
      generator: 'depth-first',
      width: 64,
      height: 64,
      seed: 1,
      loops: 0,
    });
    const race = window.labmouse
      .call('race', { mice: [], mazes: [maze], seed: 1, runs: 100 })
      .then(() => 'raced', String);
    const about = window.labmouse.call('about', {}).then(({ mice }) => mice.length);
    window.labmouse.stop('race');
    return [await race, await about];
  });
  expect(ends[0]).toContain('stopped');
  expect(ends[1]).toBeGreaterThan(10);
});
