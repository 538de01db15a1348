// What is measured of the page in Chromium. The tests take a short look, the bench a long one.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import type { Meter } from '../src/player/meter';
import { drop, native, open, temporary } from '../tests/end-to-end/harness';
import stated from './stated.json';

declare global {
  interface Window {
    /** Milliseconds after the page was opened. */
    seen: Record<string, number>;
  }
}

export type Figure = keyof typeof stated;

export const median = (list: number[]) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

/** Seconds of processor time by process, of all pages with their workers. */
async function processorTimes(page: Page): Promise<Map<number, number>> {
  const session = await page.context().browser()!.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return new Map(processInfo.filter(({ type }) => type === 'renderer').map(({ id, cpuTime }) => [id, cpuTime]));
}

/** Of those, what has passed since. */
async function processorTime(page: Page, earlier: Map<number, number>): Promise<number> {
  let sum = 0;
  for (const [id, time] of await processorTimes(page)) sum += time - (earlier.get(id) ?? 0);
  return sum;
}

export interface Opening {
  /** Seconds until something was painted, until the awaited was there, and of processor time until then. */
  paint: number;
  wall: number;
  processor: number;
}

/** Opens the page there, and waits until that element can be seen, or until the number that it shows has changed. */
export async function opening(hash: string, selector: string, moves = false): Promise<Opening> {
  let earlier = new Map<number, number>();
  const page = await open(hash, {
    before: async (fresh) => {
      earlier = await processorTimes(fresh);
      await fresh.addInitScript(
        (wanted) => {
          window.seen = {};
          let first = '';
          const look = () => {
            const element = document.querySelector<HTMLElement>(wanted.selector);
            const text = element?.textContent?.trim() ?? '';
            first ||= text;
            if (element?.checkVisibility() && (!wanted.moves || text !== first)) window.seen.it = performance.now();
            else requestAnimationFrame(look);
          };
          requestAnimationFrame(look);
        },
        { selector, moves },
      );
    },
  });
  await page.waitForFunction(() => window.seen.it > 0);
  const processor = await processorTime(page, earlier);
  const [wall, paint] = await page.evaluate(() => [
    window.seen.it,
    performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0,
  ]);
  await page.close();
  return { paint: paint / 1000, wall: wall / 1000, processor };
}

/** The home page, until its race moves. */
export const frontDoor = () => opening('', '.front-race .clock', true);

/** A mouse in *Live*, until its walk is on the stage. */
export const firstRun = () => opening('#live', '.live .player canvas');

/** Opens contests of two mice in one maze of that side, side by side. */
export async function twoMice(side: number): Promise<Page> {
  const maze = temporary(`${side}.txt`);
  native('make', 'prim', '--size', `${side}x${side}`, '--seed', '7', '-o', maze);
  const files = ['certify', 'flood'].map((mouse) => {
    const record = temporary(`${mouse}-${side}.jsonl`);
    native('run', mouse, maze, '--budget', '20000', '--record', record);
    return { name: `${mouse}.jsonl`, content: readFileSync(record) };
  });
  const page = await open('#replay');
  await drop(page, ...files);
  await page.locator('.replay .player canvas').nth(1).waitFor();
  return page;
}

/** Plays for so many seconds at that speed, again from the start where it ends: frames a second, a frame's milliseconds. */
export async function playing(page: Page, speed: string, seconds: number) {
  await page.keyboard.press('Home');
  await page.getByRole('combobox', { name: /^Speed/ }).selectOption(speed);
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  /** Seconds of processor time in which the page's scripts ran, without workers and without what paints. */
  const scripts = async () =>
    (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'ScriptDuration')!.value;
  const earlier = await scripts();
  const { frames, time } = await page.locator('.replay .player').evaluate(async (player, limit) => {
    const { meter } = player as unknown as { meter: Meter };
    const button = (label: string) => player.querySelector<HTMLButtonElement>(`button[aria-label=${label}]`);
    const [before, begin] = [meter.frames, performance.now()];
    while (performance.now() - begin < 1000 * limit) {
      // At its end it stands, and begins anew.
      button('Play')?.click();
      await new Promise((done) => setTimeout(done, 200));
    }
    button('Pause')?.click();
    return { frames: meter.frames - before, time: (performance.now() - begin) / 1000 };
  }, seconds);
  const spent = (await scripts()) - earlier;
  await session.detach();
  return { rate: frames / time, cost: (1000 * spent) / frames };
}

/** Megabytes that the page's scripts keep. */
export async function memory(page: Page): Promise<number> {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return usedSize / 1e6;
}
