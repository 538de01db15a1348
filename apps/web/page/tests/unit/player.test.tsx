// @vitest-environment happy-dom
// The player as a whole, with a canvas that takes everything and paints nothing.
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { createPlayer } from '../../src/player/player';
import type { EarlyPage } from '../../src/page/page';
import { steps } from './plays';

const canvas: unknown = new Proxy(() => canvas, { get: (_, name) => (name === 'width' ? 1 : canvas), set: () => true });

/** Frames that were asked for, to be painted by hand. */
let frames: FrameRequestCallback[] = [];
const paint = () => frames.splice(0).forEach((frame) => frame(0));

beforeEach(() => {
  frames = [];
  vi.stubGlobal('requestAnimationFrame', (frame: FrameRequestCallback) => frames.push(frame));
  vi.spyOn(HTMLCanvasElement.prototype, 'getContext').mockReturnValue(canvas as never);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

it('shows nothing in a frame that was asked for before all was taken away', () => {
  const player = createPlayer({} as EarlyPage);
  const room = document.createElement('div');
  player.enter(room);
  player.show([{ play: steps(), record: '' }]);
  expect(frames).toHaveLength(1);
  player.show([]);
  expect(paint).not.toThrow();
  expect(room.hidden).toBe(true);
});
