// The home page: a race that runs at once, and where one goes from it.
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { barriers, open, picture, proof } from './harness';

const clock = async (page: Page) => Number(await page.getByRole('timer').textContent());
const frames = (page: Page) =>
  page.locator('.front-race').evaluate((race) => (race as unknown as { meter: { frames: number } }).meter.frames);
async function opened(options = {}) {
  const page = await open('', options);
  await page.locator('.lane canvas').first().waitFor();
  return page;
}

test('a race runs at once, with its clock, both mice and the gap between them', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(1);
  expect(await page.locator('.lane').count()).toBe(2);
  await expect.poll(() => page.locator('.gap').textContent()).not.toBe('');
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await barriers(page)).toEqual([]);
  }
  await picture(page, 'home');
});

test('it begins shortly before the two mice part, for until then they look the same', async () => {
  const page = await open('', { reducedMotion: 'reduce' });
  const what = () => page.locator('.lane .doing').allTextContents();
  await expect.poll(what).toEqual(['searches', 'searches']);
  const begun = await clock(page);
  expect(begun).toBeGreaterThan(0);
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect.poll(async () => new Set(await what()).size).toBe(2);
  expect(await clock(page)).toBeLessThan(begun + 30);
});

test('it stands still where it was stopped, and where less motion is asked for', async () => {
  const page = await opened();
  await page.getByRole('button', { name: 'Pause' }).click();
  const stopped = [await clock(page), await frames(page)];
  await page.getByRole('button', { name: 'Another race' }).click();
  await expect.poll(() => clock(page)).not.toBe(stopped[0]);
  expect(await frames(page)).toBe(stopped[1]);
  const still = await opened({ reducedMotion: 'reduce' });
  await still.getByRole('button', { name: 'Run', exact: true }).waitFor();
  const [first, painted] = [await clock(still), await frames(still)];
  expect(painted).toBe(0);
  await still.getByRole('button', { name: 'Run', exact: true }).click();
  await expect.poll(() => clock(still)).toBeGreaterThan(first);
});

test('it costs nothing while another view is shown, and goes on afterwards', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(0);
  await page.getByRole('link', { name: 'Draw' }).click();
  await page.locator('.draw .stage canvas').waitFor();
  const before = await frames(page);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  expect(await frames(page)).toBe(before);
  await page.goBack();
  await expect.poll(() => frames(page)).toBeGreaterThan(before);
});

declare global {
  interface Window {
    /** Frames of the browser that the page asked for, calls of its core, and a wait for so many frames. */
    costs: { frames: number; calls: number; pass(frames: number): Promise<void> };
  }
}

/** Counts what the page does, from its first line on; whether its tab can be seen, the test says. */
const counting = (hidden: boolean, options = {}) => ({
  ...options,
  before: (page: Page) =>
    page.addInitScript((first) => {
      let isHidden = first;
      Object.defineProperty(document, 'hidden', { get: () => isHidden });
      addEventListener('turn', () => {
        isHidden = !isHidden;
        document.dispatchEvent(new Event('visibilitychange'));
      });
      const frame = requestAnimationFrame.bind(window);
      const pass = async (frames: number) => {
        for (let i = 0; i < frames; ++i) await new Promise(frame);
      };
      window.costs = { frames: 0, calls: 0, pass };
      window.requestAnimationFrame = (act) => (++window.costs.frames, frame(act));
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (this: Worker, ...message: [never]) {
        ++window.costs.calls;
        postMessage.apply(this, message);
      };
    }, hidden),
});
/** Hides the tab, or shows it. */
const turn = (page: Page) => page.evaluate(() => void dispatchEvent(new Event('turn')));
/** What the page does while the browser paints so many frames, which it does here whether the tab is seen or not. */
const costsOf = (page: Page) =>
  page.evaluate(async () => {
    const { frames, calls, pass } = window.costs;
    await pass(30);
    return [window.costs.frames - frames, window.costs.calls - calls];
  });

/** Waits until the page asks for no frame and calls nothing: what it asked for before is answered and drawn first. */
const rests = (page: Page) => expect.poll(() => costsOf(page)).toEqual([0, 0]);

test('in a tab that is hidden it costs no frame and no call, and nothing is asked of the core before it is seen', async () => {
  const page = await open('', counting(true));
  await page.getByRole('button', { name: 'Watch' }).waitFor();
  await rests(page);
  expect(await page.locator('.lane').count()).toBe(0);
  await turn(page);
  await expect.poll(() => clock(page)).toBeGreaterThan(0);
  await turn(page);
  await rests(page);
  const then = await clock(page);
  await turn(page);
  await expect.poll(() => clock(page)).toBeGreaterThan(then);
});

test('a replay in a tab that is hidden costs nothing either', async () => {
  const page = await open('#replay', counting(false));
  const position = () => page.getByRole('slider', { name: 'Moment of the replay' }).inputValue();
  await expect.poll(async () => Number(await position())).toBeGreaterThan(1);
  await turn(page);
  await rests(page);
  const then = Number(await position());
  await turn(page);
  await expect.poll(async () => Number(await position())).toBeGreaterThan(then);
});

test.each(proof ? ['', '#replay', '#live', '#race', '#write', '#draw', '#robot'] : ['', '#race'])(
  'where less motion is asked for, nothing moves by itself: %s',
  async (hash) => {
    const page = await open(hash, counting(false, { reducedMotion: 'reduce' }));
    await page.locator('.stage canvas:visible').first().waitFor();
    await rests(page);
    expect(await page.getByRole('button', { name: 'Pause' }).count()).toBe(0);
  },
);

test('who wants to see it closely is taken to that moment of it', async () => {
  const page = await opened();
  await expect.poll(() => clock(page)).toBeGreaterThan(2);
  await page.getByRole('button', { name: 'Pause' }).click();
  const time = await clock(page);
  const [first] = await page.locator('.lane strong').allTextContents();
  await page.getByRole('button', { name: 'Watch' }).click();
  await expect.poll(() => page.locator('.replay .moment').textContent()).toContain(`${first} at `);
  const moment = (await page.locator('.replay .moment').textContent())!;
  expect(Number(/ at ([\d.]+) of/.exec(moment)![1])).toBeCloseTo(time, 1);
});

test('on a telephone both mazes and all ways on are on the first screen', async () => {
  const page = await opened({ viewport: { width: 390, height: 844 }, hasTouch: true });
  for (const place of [
    ...(await page.locator('.lane canvas').all()),
    page.getByRole('link', { name: 'Race', exact: true }).last(),
  ]) {
    const box = (await place.boundingBox())!;
    expect(box.y + box.height).toBeLessThanOrEqual(844);
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
});
