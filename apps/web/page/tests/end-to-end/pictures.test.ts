// Pictures and films of what is on the stage.
import { readFileSync, writeFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { drop, native, open, proof, replayed, temporary } from './harness';

const replay = (page: Page) => page.getByRole('region', { name: 'Replay' });

async function saved(page: Page, button: string, place = replay(page)): Promise<{ name: string; content: Buffer }> {
  const waiting = page.waitForEvent('download', { timeout: 120_000 });
  await place.getByRole('button', { name: button, exact: true }).click();
  const download = await waiting;
  const path = temporary(download.suggestedFilename());
  await download.saveAs(path);
  return { name: download.suggestedFilename(), content: readFileSync(path) };
}

async function openReplay(hash: string) {
  const page = await open(hash);
  await replay(page).locator('.side canvas').first().waitFor();
  return page;
}

/** Size, delays of the frames in milliseconds, and whether it is whole: its blocks, one after the other. */
function readGif(bytes: Buffer) {
  expect(bytes.subarray(0, 6).toString('latin1')).toBe('GIF89a');
  const [width, height] = [bytes.readUInt16LE(6), bytes.readUInt16LE(8)];
  const table = (flags: number) => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  const delays: number[] = [];
  let frames = 0;
  let at = 13 + table(bytes[10]);
  const skip = () => {
    while (bytes[at] !== 0) at += bytes[at] + 1;
    ++at;
  };
  while (bytes[at] !== 0x3b && at < bytes.length) {
    if (bytes[at] === 0x21) {
      if (bytes[at + 1] === 0xf9) delays.push(10 * bytes.readUInt16LE(at + 4));
      at += 2;
      skip();
    } else if (bytes[at] === 0x2c) {
      ++frames;
      at += 10 + table(bytes[at + 9]) + 1;
      skip();
    } else throw new Error(`no block of a GIF at ${at}: ${bytes[at]}`);
  }
  return { width, height, delays, frames, whole: at === bytes.length - 1 };
}

const pngSize = (bytes: Buffer) => ({ width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) });
const single = '#replay&mouse=flood&in=contest-02&seed=1&at=30';
const double = '#replay&mouse=ariadne&mouse=flood&in=contest-02&seed=1&at=30';

test('a PNG is as large as the stage at two pixels to one, with names and time', async () => {
  const page = await openReplay(double);
  const canvases = replay(page).locator('.side canvas');
  await expect.poll(() => canvases.count()).toBe(2);
  const boxes = await Promise.all([0, 1].map(async (i) => (await canvases.nth(i).boundingBox())!));
  const { name, content } = await saved(page, 'Save moment (PNG)');
  expect(name).toBe('ariadne-flood-contest-02.png');
  const { width, height } = pngSize(content);
  const ratio = width / (boxes[0].width + boxes[1].width + 3 * 16);
  expect(ratio).toBeGreaterThan(1.95);
  expect(ratio).toBeLessThan(2.05);
  expect(Math.abs(height / ratio - boxes[0].height - 60)).toBeLessThan(8);
  writeFileSync(temporary('seen.png'), content);
});

test('a drawing and the best route of a robot are saved, too', async () => {
  const page = await open('#draw&in=contest-02');
  const draw = page.getByRole('region', { name: 'Draw' });
  await draw.getByRole('heading', { name: /contest-02/ }).waitFor();
  const drawn = await saved(page, 'pixels', draw);
  expect(drawn.name).toBe('contest-02.png');
  expect(pngSize(drawn.content).height).toBeGreaterThan(1500);
  const other = await open('#robot&in=contest-02&robot=classic');
  const robot = other.getByRole('region', { name: 'Robot', exact: true });
  await robot.getByRole('img', { name: /best route of contest-02/ }).waitFor();
  const pixels = await saved(other, 'Save route (PNG)', robot);
  expect(pixels.name).toBe('classic-contest-02.png');
  expect(pngSize(pixels.content)).toEqual(pngSize(drawn.content));
  const lines = (await saved(other, 'Save route (SVG)', robot)).content.toString();
  // The route is the one long line.
  const strokes = [...lines.matchAll(/<path d="([^"]*)" fill="none"/g)].map(([, path]) => path.split('L').length);
  expect(strokes.filter((pieces) => pieces > 30)).toHaveLength(1);
});

test('an SVG holds the names, the time and the maze, and stands by itself', async () => {
  const page = await openReplay(double);
  const { content } = await saved(page, 'Save moment (SVG)');
  const found = await page.evaluate((text) => {
    const picture = new DOMParser().parseFromString(text, 'image/svg+xml');
    const words = [...picture.querySelectorAll('text')].map((one) => one.textContent);
    return {
      broken: picture.querySelector('parsererror') !== null,
      words,
      mazes: picture.querySelectorAll('svg > svg').length,
      strange: picture.querySelectorAll('script, style, image, [href]').length,
    };
  }, content.toString());
  expect(found).toMatchObject({ broken: false, mazes: 2, strange: 0 });
  expect(found.words).toEqual(expect.arrayContaining(['ariadne', 'flood', '30 steps']));
});

/** What a browser makes of an image: the sum of its light, so that an empty one is told from a drawn one. */
const seenBy = (page: Page, content: Buffer, type: string) =>
  page.evaluate(
    async ([bytes, kind]) => {
      const image = new Image();
      image.src = `data:${kind};base64,${bytes}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      canvas.width = image.naturalWidth;
      canvas.height = image.naturalHeight;
      const context = canvas.getContext('2d')!;
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const tones = new Set<number>();
      for (let i = 0; i < data.length; i += 4) tones.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      return tones.size;
    },
    [content.toString('base64'), type],
  );

/** How many pixels of a film's last frame are other than in its first. */
const changedInFilm = (page: Page, gif: Buffer) =>
  page.evaluate(async (bytes) => {
    const data = Uint8Array.from(atob(bytes), (sign) => sign.charCodeAt(0));
    const decoder = new ImageDecoder({ data, type: 'image/gif' });
    await decoder.tracks.ready;
    await decoder.completed;
    const last = decoder.tracks.selectedTrack!.frameCount - 1;
    const frames: Uint32Array[] = [];
    for (const frameIndex of [0, last]) {
      const { image } = await decoder.decode({ frameIndex });
      const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
      const context = canvas.getContext('2d')!;
      context.drawImage(image, 0, 0);
      frames.push(new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer));
    }
    return frames[0].reduce((sum, pixel, i) => sum + Number(pixel !== frames[1][i]), 0);
  }, gif.toString('base64'));

test('PNG and SVG show the same tones of a maze', async () => {
  const page = await openReplay(single);
  expect(await seenBy(page, (await saved(page, 'Save moment (PNG)')).content, 'image/png')).toBeGreaterThan(20);
  expect(await seenBy(page, (await saved(page, 'Save moment (SVG)')).content, 'image/svg+xml')).toBeGreaterThan(20);
});

test('a film has a frame for each step, its clock, and less than five megabytes', async () => {
  const page = await openReplay(single);
  const { name, content } = await saved(page, 'Save film (GIF)');
  expect(name).toBe('flood-contest-02.gif');
  const steps = Number(await replay(page).getByRole('slider').getAttribute('max'));
  const gif = readGif(content);
  expect(gif).toMatchObject({ frames: steps + 1, whole: true });
  expect(Math.min(...gif.delays)).toBeGreaterThanOrEqual(20);
  expect(content.length).toBeLessThan(5_000_000);
  expect(await seenBy(page, content, 'image/gif')).toBeGreaterThan(5);
  // The mouse has gone elsewhere, and what it saw is drawn by then.
  expect(await changedInFilm(page, content)).toBeGreaterThan(1000);
  console.log(`film of ${gif.frames} frames, ${gif.width}×${gif.height}: ${content.length} bytes`);
  await expect.poll(() => page.locator('.status').textContent()).toContain('The film is saved');
});

test.runIf(proof)('two mice in seconds are filmed beside each other', async () => {
  const page = await openReplay('#replay&mouse=ariadne&mouse=flood&in=contest-02&seed=1&robot=classic&rules=all-japan');
  const { content } = await saved(page, 'Save film (GIF)');
  const gif = readGif(content);
  expect(gif.whole).toBe(true);
  expect(gif.width).toBeGreaterThan(1.5 * gif.height);
  expect(content.length).toBeLessThan(5_000_000);
  console.log(`film of ${gif.frames} frames, ${gif.width}×${gif.height}: ${content.length} bytes`);
});

test.runIf(proof)(
  'a film of a long contest in a large maze leaves steps out, and says so',
  async () => {
    const page = await open('#replay');
    const maze = temporary('large.txt');
    writeFileSync(maze, native('make', 'prim', '--size', '64x64', '--seed', '1'));
    const record = temporary('large.jsonl');
    native('run', 'flood', maze, '--budget', '100000', '--record', record);
    await drop(page, { name: 'large.jsonl', content: readFileSync(record) });
    await replayed(page, '64 × 64');
    const { content } = await saved(page, 'Save film (GIF)');
    expect(readGif(content).whole).toBe(true);
    expect(content.length).toBeLessThan(5_000_000);
    await expect.poll(() => page.locator('.status').textContent()).toContain('left out');
  },
  150_000,
);

test('a film can be stopped', async () => {
  const page = await openReplay('#replay&mouse=random&in=contest-02&seed=1');
  await replay(page).getByRole('button', { name: 'Save film (GIF)' }).click();
  await replay(page)
    .getByRole('button', { name: 'Stop the film' })
    .evaluate((button: HTMLButtonElement) => button.click());
  await expect.poll(() => page.locator('.status').textContent()).toBe('The film was stopped.');
  expect(await replay(page).getByRole('button', { name: 'Save film (GIF)' }).isEnabled()).toBe(true);
});
