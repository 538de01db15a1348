// The pictures of README and docs/reference/page.md: `npm run pictures`. Those of how the page was before are made from another page, by
// `LABMOUSE_BEFORE=FILE npm run pictures`, where FILE is what scripts/page builds of commit f77c142.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { applyPalette, GIFEncoder, quantize } from 'gifenc';
import type { Page } from 'playwright-core';
import { test } from 'vitest';
import { open, picture, root } from '../tests/end-to-end/harness';
import { indexedPng } from './png';

const before = process.env.LABMOUSE_BEFORE;
const themes = ['light', 'dark'] as const;
const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 700 },
  { width: 390, height: 844 },
];

interface View {
  title: string;
  /** Of the picture, where it is not that of the view. */
  name?: string;
  hash: string;
  /** What can be seen once all is there. */
  until: string;
  /** Goes to the moment of the picture. */
  go?: (page: Page) => Promise<unknown>;
}

async function scrub(page: Page, time: string) {
  await page.getByRole('slider').first().fill(time);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
}

const views: View[] = [
  { title: 'The home page', hash: '#home&pair=2&at=75', until: '.lane canvas' },
  { title: 'Race', hash: '#race', until: '.race [aria-label="Leaderboard, table"]' },
  { title: 'Replay', hash: '#replay&mouse=ariadne&in=contest-01&seed=1&at=60', until: '.replay .stage canvas' },
  { title: 'Live', hash: '#live&mouse=certify&in=contest-02&seed=1&at=70', until: '.live .stage canvas' },
  { title: 'Draw', hash: '#draw&in=contest-02', until: '.draw .verdict' },
  { title: 'Write', hash: '#write', until: '.write .verdict[data-state=good]', go: (page) => scrub(page, '30') },
  { title: 'Robot', hash: '#robot&in=contest-01&robot=classic', until: '.robot [aria-label="The best route"]' },
];
const viewsBefore: View[] = [
  { title: 'Race', hash: '', until: 'text=See a mouse run' },
  {
    title: 'Replay',
    hash: '#race',
    until: 'text=See a mouse run',
    async go(page) {
      await page.getByText('See a mouse run').click();
      await page.locator('.replay canvas').first().waitFor();
      await scrub(page, '60');
    },
  },
  { title: 'Live', hash: '#live&mouse=certify', until: '.live canvas' },
  { title: 'Draw', hash: '#draw', until: '.draw canvas' },
];

/** What a window of that size shows: a PNG as base64. */
async function shot(view: View, colorScheme: (typeof themes)[number], viewport: (typeof sizes)[number], file?: string) {
  const page = await open(view.hash, { file, viewport, colorScheme, reducedMotion: 'reduce', before: async () => {} });
  await page.locator(view.until).first().waitFor();
  await view.go?.(page);
  // All that was asked of the core is there and painted.
  await page.evaluate(async () => {
    await (window as unknown as { labmouse: { call(name: string, request: object): unknown } }).labmouse.call(
      'about',
      {},
    );
    for (let i = 0; i < 30; ++i) await new Promise(requestAnimationFrame);
  });
  // As it is, too, for the eye.
  const name = [file ? 'before' : 'now', view.name ?? view.title, viewport.width, colorScheme]
    .join('-')
    .replaceAll(' ', '-');
  await picture(page, name);
  const bytes = readFileSync(join(root, `build/page/pictures/${name}.png`));
  await page.context().close();
  return { title: view.title, image: bytes.toString('base64'), ...viewport };
}
type Shot = Awaited<ReturnType<typeof shot>>;

/** Draws them in rows, each under its title, at that scale. */
async function sheet(name: string, rows: Shot[][], scale: number) {
  const page = await open('#draw', { before: async () => {} });
  const { width, height, rgba } = await page.evaluate(
    async ({ rows, scale }) => {
      const [gap, line] = rows.length > 1 ? [12, 28] : [0, 0];
      const wide = (row: Shot[]) => row.reduce((sum, one) => sum + scale * one.width + gap, gap);
      const high = (row: Shot[]) => scale * Math.max(...row.map((one) => one.height)) + line;
      const canvas = new OffscreenCanvas(
        Math.ceil(Math.max(...rows.map(wide))),
        Math.ceil(rows.reduce((sum, row) => sum + high(row), gap)),
      );
      const context = canvas.getContext('2d')!;
      context.imageSmoothingQuality = 'high';
      context.fillStyle = '#7d8791';
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.font = '600 16px sans-serif';
      let y = 0;
      for (const row of rows) {
        let x = gap;
        context.fillStyle = '#ffffff';
        if (line > 0) context.fillText(row[0].title, x, y + 20);
        for (const { image, width, height } of row) {
          const bytes = Uint8Array.from(atob(image), (sign) => sign.charCodeAt(0));
          const picture = await createImageBitmap(new Blob([bytes]));
          context.drawImage(picture, x, y + line, scale * width, scale * height);
          x += scale * width + gap;
        }
        y += high(row);
      }
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      let text = '';
      for (let i = 0; i < data.length; i += 0x8000) text += String.fromCharCode(...data.subarray(i, i + 0x8000));
      return { width: canvas.width, height: canvas.height, rgba: btoa(text) };
    },
    { rows, scale },
  );
  await page.context().close();
  const pixels = new Uint8ClampedArray(Buffer.from(rgba, 'base64'));
  writeFileSync(join(root, `docs/${name}.png`), indexedPng(pixels, width, height));
}

async function compared(name: string, list: View[], file?: string) {
  for (const theme of themes) {
    const rows: Shot[][] = [];
    for (const view of list) {
      const row: Shot[] = [];
      for (const size of sizes) row.push(await shot(view, theme, size, file));
      rows.push(row);
    }
    await sheet(`page-${name}-${theme}`, rows, 0.5);
  }
}

test('before and after', { timeout: 600_000 }, () =>
  before ? compared('before', viewsBefore, before) : compared('after', views),
);

const someRace = '#race&mouse=ariadne&mouse=flood-return&mouse=certify&mouse=flood&mouse=frontier&in=all&seed=1';
const regions = '#robot&in=contest-01&robot=classic&vary=curve.lateral_acceleration,4000,16000';
const singles: [name: string, view: View][] = [
  ['home', views[0]],
  [
    'race',
    {
      title: 'Race',
      hash: someRace,
      until: 'text=Start the race',
      async go(page) {
        await page.getByRole('button', { name: 'Start the race' }).click();
        const pictures = page.locator('.race .matrix canvas');
        await pictures.first().waitFor({ timeout: 120_000 });
        await page.locator('.race-view .race.pictures').evaluate((place) => place.scrollIntoView());
      },
    },
  ],
  ['replay', views[2]],
  [
    'seconds',
    {
      title: 'Replay',
      hash: '#replay&mouse=certify&in=contest-02&seed=1&robot=classic&rules=all-japan&at=71.2',
      until: '.replay .speeds canvas',
    },
  ],
  ['live', views[3]],
  ['draw', views[4]],
  ['write', views[5]],
  ['robot', views[6]],
  [
    'regions',
    {
      title: 'Robot',
      hash: regions,
      until: '.regions img',
      go: (page) => page.locator('.regions').evaluate((place) => place.scrollIntoView()),
    },
  ],
];
test.skipIf(before)('each view', { timeout: 300_000 }, async () => {
  for (const [name, view] of singles)
    await sheet(`page-${name}`, [[await shot({ ...view, name }, 'light', sizes[0])]], 0.75);
});

// As large as README shows it: the search runs at 27 times their speed, the speed runs, which begin after 90 s, at three.
test.skipIf(before)('the home page moves', { timeout: 300_000 }, async () => {
  const size = { width: 640, height: 400 };
  const times = [...Array(23).keys()].map((i) => 1 + 4 * i).concat([...Array(16).keys()].map((i) => 90 + 0.45 * i));
  const page = await open('#home&pair=2&at=1', { viewport: sizes[0], reducedMotion: 'reduce', before: async () => {} });
  await page.locator('.lane canvas').first().waitFor();
  const gif = GIFEncoder();
  const frames: Uint8ClampedArray[] = [];
  for (const time of times) {
    await page.evaluate(async (hash) => {
      location.hash = hash;
      for (let i = 0; i < 4; ++i) await new Promise(requestAnimationFrame);
    }, `#home&pair=2&at=${time}`);
    const image = (await page.screenshot()).toString('base64');
    const rgba = await page.evaluate(
      async ({ image, width, height }) => {
        const bytes = Uint8Array.from(atob(image), (sign) => sign.charCodeAt(0));
        const context = new OffscreenCanvas(width, height).getContext('2d')!;
        context.imageSmoothingQuality = 'high';
        context.drawImage(await createImageBitmap(new Blob([bytes])), 0, 0, width, height);
        const { data } = context.getImageData(0, 0, width, height);
        let text = '';
        for (let i = 0; i < data.length; i += 0x8000) text += String.fromCharCode(...data.subarray(i, i + 0x8000));
        return btoa(text);
      },
      { image, ...size },
    );
    frames.push(new Uint8ClampedArray(Buffer.from(rgba, 'base64')));
  }
  await page.context().close();
  // All frames have the colours of the last, which has most, and one for what is as in the frame before.
  const palette = quantize(frames.at(-1)!, 127);
  const unchanged = palette.push([0, 0, 0]) - 1;
  let before: Uint8Array | undefined;
  for (const frame of frames) {
    const index = applyPalette(frame, palette.slice(0, unchanged));
    gif.writeFrame(
      index.map((colour, pixel) => (colour === before?.[pixel] ? unchanged : colour)),
      size.width,
      size.height,
      {
        palette,
        delay: frame === frames.at(-1) ? 3000 : 150,
        transparent: true,
        transparentIndex: unchanged,
        dispose: 1,
      },
    );
    before = index;
  }
  gif.finish();
  writeFileSync(join(root, 'docs/page-home.gif'), gif.bytes());
});
