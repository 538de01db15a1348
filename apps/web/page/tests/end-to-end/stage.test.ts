// The picture comes first: how large it is, what is beside it on the first screen, and closer looks at it.
import type { Locator, Page } from 'playwright-core';
import { describe, expect, it, test } from 'vitest';
import { choose, open, proof } from './harness';

const desk = { width: 1440, height: 900 };
const phone = { width: 390, height: 844 };

async function replayed(mice: string, options: object) {
  const page = await open('#replay', options);
  await choose(page, mice.split(' and '), 'contest-01');
  return page;
}
async function walked(options: object) {
  const page = await open('#live', options);
  await page.locator('.live .stage canvas').waitFor();
  return page;
}
/** Live, with the walk from before a change beside it. */
async function walkedTwice(options: object) {
  const page = await walked(options);
  await page.getByRole('region', { name: 'Mouse' }).getByLabel('Name').selectOption('certify');
  await page.getByLabel('Compare with before').check();
  await page.locator('.live .stage canvas').nth(1).waitFor();
  await page.evaluate(() => scrollTo(0, 0));
  return page;
}
const boxOf = async (place: Locator) => (await place.boundingBox())!;
/** All of it is in the window as it was opened. */
async function onFirstScreen(page: Page, ...places: Locator[]) {
  for (const place of places)
    for (const one of await place.all()) {
      const box = await boxOf(one);
      expect(box.y).toBeGreaterThanOrEqual(0);
      expect(box.y + box.height).toBeLessThanOrEqual(page.viewportSize()!.height);
    }
}
const pixels = (page: Page) =>
  page
    .locator('.replay .stage canvas')
    .first()
    .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());

/** Each view, with a maze of 16 by 16 on its stage. */
const views: [string, (options: object) => Promise<Page>][] = [
  ['replay', (options) => replayed('ariadne', options)],
  ['live', walked],
  ['draw', (options) => open('#draw', options)],
  ['race', (options) => open('#race', options)],
  [
    'write',
    async (options) => {
      const page = await open('#write', options);
      await page.getByRole('img', { name: 'Maze capstone-1' }).waitFor();
      await page.getByRole('combobox', { name: 'Maze' }).selectOption('contest-01');
      await page.getByRole('button', { name: 'Run', exact: true }).click();
      await page.getByRole('img', { name: 'Maze contest-01' }).waitFor();
      await page.evaluate(() => scrollTo(0, 0));
      return page;
    },
  ],
  [
    'robot',
    async (options) => {
      const page = await open('#robot', options);
      await page
        .getByRole('region', { name: 'Robot', exact: true })
        .getByLabel('Built-in maze')
        .selectOption('contest-01');
      await page.getByRole('img', { name: 'The best route of contest-01' }).waitFor();
      return page;
    },
  ],
];
const labels: Record<string, string> = {
  race: 'Race',
  replay: 'Replay',
  live: 'Live',
  draw: 'Draw',
  write: 'Write',
  robot: 'Robot',
};

describe.each(views)('the stage of %s', (name, opened) => {
  const stage = (page: Page) =>
    page.getByRole('region', { name: labels[name], exact: true }).locator('.stage canvas').first();
  const numbers = 18;
  const windows: [typeof desk, number][] = [
    [desk, 760],
    [{ width: 1024, height: 700 }, 520],
  ];
  it.each(proof ? windows : windows.slice(1))('has all the height of a window: %o', async (viewport, least) => {
    const page = await opened({ viewport });
    const canvas = stage(page);
    await canvas.waitFor();
    await expect.poll(async () => (await boxOf(canvas)).height - numbers).toBeGreaterThan(least);
    const caption = page.locator(':is(.player, .robot-room) figcaption:visible');
    const line = page.locator(':is(.transport, .robot-room .looks, .draw-tools):visible');
    expect([await caption.count(), await line.count()]).toEqual([name === 'draw' ? 0 : 1, 1]);
    await onFirstScreen(page, canvas, caption, line);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
  });
  it('has the window to itself where the panels are put away', async () => {
    const page = await opened({ viewport: desk });
    const canvas = stage(page);
    await canvas.waitFor();
    const panels = page.locator(':is(.panel, .desk-side, .desk-panel, .desk-editor, .race-stage > .race):visible');
    await expect.poll(() => panels.count()).toBeGreaterThan(0);
    const before = await boxOf(canvas);
    // What has the focus may need the key itself.
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press('p');
    await expect.poll(() => panels.count()).toBe(0);
    await expect.poll(async () => (await boxOf(canvas)).height).toBeGreaterThanOrEqual(before.height);
    // Nearer by a key and by a button, and the whole again.
    const close = page.locator('.stage.close:visible');
    await page.keyboard.press('z');
    await expect.poll(() => close.count()).toBe(1);
    await page.keyboard.press('x');
    await expect.poll(() => close.count()).toBe(0);
    await page.getByRole('button', { name: 'Nearer' }).click();
    await expect.poll(() => close.count()).toBe(1);
    await page.getByRole('button', { name: 'Full screen' }).click();
    await expect.poll(() => page.evaluate(() => document.fullscreenElement !== null)).toBe(true);
    await page.keyboard.press('f');
    await expect.poll(() => page.evaluate(() => document.fullscreenElement)).toBe(null);
    await page.getByRole('button', { name: 'The panel' }).click();
    await expect.poll(() => panels.count()).toBeGreaterThan(0);
  });
});

test.runIf(proof)('the slider has room to be dragged in windows of any width', async () => {
  const slider = (page: Page) => page.getByRole('slider', { name: 'Moment of the replay' });
  for (const width of [1024, 1180, 1440]) {
    const live = await walked({ viewport: { width, height: 700 } });
    expect((await boxOf(slider(live))).width).toBeGreaterThan(200);
  }
});

test.runIf(proof)('on a telephone maze, controls and slider are on the first screen, also with two mice', async () => {
  const options = { viewport: phone, hasTouch: true };
  const slider = (page: Page) => page.getByRole('slider', { name: 'Moment of the replay' });
  const [raced, written] = ['race', 'write'].map((name) => views.find(([view]) => view === name)![1]);
  const opened = [() => replayed('ariadne and flood', options), walked, walkedTwice, raced, written];
  for (const open of opened) {
    const page = await open(options);
    await slider(page).waitFor();
    const canvases = page.locator('.player .stage canvas:visible');
    await onFirstScreen(page, canvases, slider(page), page.locator('.transport:visible'));
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(phone.width);
    // Beneath them stands what one does next, before all numbers.
    const next = page.getByRole('button', { name: /^(Start the race|Run)$/ }).first();
    const numbers = page.locator('.player .panel:visible').first();
    if (open === raced) expect(await numbers.count()).toBe(0);
    if (open === written) expect((await boxOf(next)).y).toBeLessThan((await boxOf(numbers)).y);
  }
});

/** Whatever can be hit, save links inside of sentences, which are as high as their lines, and what only keys reach. */
const tooSmall = (page: Page) =>
  page.evaluate(() => {
    const all = 'a[href], button, select, summary, input, textarea, [role=button], label:has(> input)';
    const target = (one: Element) =>
      one.matches('[type=checkbox], [type=radio]') ? (one.closest('label') ?? one) : one;
    return [...document.querySelectorAll(all)]
      .map(target)
      .filter((one) => one.checkVisibility() && !one.matches('.skip, p a') && !one.closest('[inert]'))
      .filter((one) => {
        const { width, height } = one.getBoundingClientRect();
        return Math.round(height) < 44 || Math.round(width) < 44;
      })
      .map((one) => `${one.getBoundingClientRect().height} ${one.outerHTML.slice(0, 80)}`);
  });

const inSeconds = '#live&mouse=certify&in=contest-02&seed=1&robot=classic&rules=all-japan';
const others = [
  ['home', (options: object) => open('', options)],
  ['live in seconds', (options: object) => open(inSeconds, options)],
] as const;

it.each([...views, ...others])('what a finger hits is large enough: %s', async (_, opened) => {
  const page = await opened({ viewport: phone, hasTouch: true });
  await page.locator('.stage canvas:visible').first().waitFor();
  for (const folded of await page.locator('details:visible:not([open]) > summary').all())
    if (await folded.isVisible()) await folded.click();
  expect(await tooSmall(page)).toEqual([]);
});

test('the wheel and the keys look closer, a drag looks aside, and the whole comes back', async () => {
  const page = await replayed('ariadne', { viewport: desk });
  const canvas = page.locator('.replay .stage canvas');
  const whole = await pixels(page);
  const box = await boxOf(canvas);
  await page.mouse.move(box.x + 200, box.y + 600);
  await page.mouse.wheel(0, -400);
  await expect.poll(() => pixels(page)).not.toBe(whole);
  const near = await pixels(page);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 500);
  await page.mouse.up();
  await expect.poll(() => pixels(page)).not.toBe(near);
  const moved = await pixels(page);
  await page.keyboard.press('d');
  await expect.poll(() => pixels(page)).not.toBe(moved);
  for (let i = 0; i < 8; ++i) await page.keyboard.press('x');
  await expect.poll(() => pixels(page)).toBe(whole);
  await page.getByRole('button', { name: 'Nearer' }).click();
  await expect.poll(() => pixels(page)).not.toBe(whole);
});

test('the panel folds away, and the maze moves to the middle', async () => {
  const page = await replayed('ariadne', { viewport: desk });
  const canvas = page.locator('.replay .stage canvas');
  const before = await boxOf(canvas);
  await page.keyboard.press('p');
  await page.locator('.replay .panel').waitFor({ state: 'hidden' });
  await expect.poll(async () => (await boxOf(canvas)).x).toBeGreaterThan(before.x + 100);
  await page.getByRole('button', { name: 'The panel' }).click();
  await page.locator('.replay .panel').waitFor();
});

test('a drawing is looked at closer, and drawn there', async () => {
  const page = await open('#draw', { viewport: desk });
  const canvas = page.getByRole('application', { name: /^Drawing of/ });
  await page.getByRole('button', { name: 'Nearer' }).click();
  const box = await boxOf(canvas);
  await page.mouse.move(box.x + 120, box.y + 120);
  await page.mouse.wheel(0, -600);
  const undo = page.getByRole('button', { name: 'Undo' });
  expect(await undo.isDisabled()).toBe(true);
  await canvas.focus();
  for (const key of ['ArrowUp', 'ArrowUp', 'd']) await page.keyboard.press(key);
  await expect.poll(() => undo.isEnabled()).toBe(true);
});

/** Two fingers that go apart, through the debugger: a page cannot make them itself. The first comes down on a wall. */
async function pinch(page: Page, canvas: Locator) {
  const box = await boxOf(canvas);
  const pitch = (box.width - 24) / 16;
  const [x, y] = [box.x + 24 + 4 * pitch + 20, box.y + box.height - 20 - 3.5 * pitch];
  const client = await page.context().newCDPSession(page);
  const fingers = (apart: number) => [
    { x: x - apart, y, id: 1 },
    { x: x + apart, y, id: 2 },
  ];
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [fingers(20)[0]] });
  await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(20) });
  for (const apart of [30, 45, 60, 80])
    await client.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: fingers(apart) });
  await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

test.runIf(proof)('two fingers look closer, and draw nothing', async () => {
  const options = { viewport: phone, hasTouch: true };
  const replay = await replayed('ariadne', options);
  const whole = await pixels(replay);
  await pinch(replay, replay.locator('.replay .stage canvas'));
  await expect.poll(() => replay.locator('.replay .stage').getAttribute('class')).toContain('close');
  expect(await pixels(replay)).not.toBe(whole);
  const draw = await open('#draw', options);
  const canvas = draw.getByRole('application', { name: /^Drawing of/ });
  await canvas.waitFor();
  await pinch(draw, canvas);
  await expect.poll(() => draw.locator('.draw .stage').getAttribute('class')).toContain('close');
  expect(await draw.getByRole('button', { name: 'Undo' }).isDisabled()).toBe(true);
});
