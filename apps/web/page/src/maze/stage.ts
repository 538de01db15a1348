// A canvas for a maze that is as large as its place allows, and crisp at every zoom.
import { h } from '../ui/dom';
import { onTones } from '../ui/tones';
import { bare, fit, numbered, type Geometry, type MazeSize } from './geometry';
import { readPalette, type Palette } from './palette';
import type { Context } from './painter';

/** Device pixels to a pixel of the page, at least, while it is printed. */
const printRatio = 3;

export interface Stage {
  /** As wide as its parent; the canvas in it has role=img. */
  element: HTMLElement;
  canvas: HTMLCanvasElement;
  geometry(): Geometry;
  palette(): Palette;
  /** For another maze. */
  resize(maze: MazeSize): void;
  /** Paints before the next frame of the browser, however often it is called; `now` at once. */
  redraw(): void;
  now(): void;
  /** What the picture shows, for those who do not see it. */
  describe(text: string): void;
  close(): void;
}

export interface StageOptions {
  /** Numbers of columns and rows beside the maze need room. */
  numbers?: boolean;
  /** Most pixels of the page in height; 80 % of the window where it is missing. */
  tallest?: () => number;
  /** Called after the geometry or the palette has changed, before `paint`. */
  changed?: (geometry: Geometry, palette: Palette) => void;
}

export function createStage(
  maze: MazeSize,
  paint: (context: Context, geometry: Geometry, palette: Palette) => void,
  options: StageOptions = {},
): Stage {
  const canvas = h('canvas', { role: 'img' });
  const element = h('div', { class: 'stage' }, canvas);
  const context = canvas.getContext('2d', { alpha: false })!;
  const margins = options.numbers ? numbered : bare;
  const tallest = options.tallest ?? (() => innerHeight * 0.8);
  let size = maze;
  let palette = readPalette();
  let geometry = fit(size, 300, 300, 1, margins);
  let printing = false;
  let waiting = 0;

  function now() {
    cancelAnimationFrame(waiting);
    waiting = 0;
    paint(context, geometry, palette);
  }
  function redraw() {
    if (!waiting) waiting = requestAnimationFrame(now);
  }
  function measure() {
    const width = element.clientWidth;
    if (width === 0) return;
    const ratio = printing ? Math.max(printRatio, devicePixelRatio) : devicePixelRatio;
    geometry = fit(size, width, tallest(), ratio, margins);
    if (canvas.width !== geometry.canvasWidth || canvas.height !== geometry.canvasHeight) {
      canvas.width = geometry.canvasWidth;
      canvas.height = geometry.canvasHeight;
    }
    canvas.style.width = `${geometry.canvasWidth / ratio}px`;
    canvas.style.height = `${geometry.canvasHeight / ratio}px`;
    options.changed?.(geometry, palette);
    now();
  }
  function recolour() {
    palette = readPalette();
    options.changed?.(geometry, palette);
    now();
  }
  function print(event: Event) {
    printing = event.type === 'beforeprint';
    palette = readPalette();
    measure();
  }

  const observer = new ResizeObserver(measure);
  observer.observe(element);
  const unwatch = onTones(recolour);
  addEventListener('resize', measure);
  addEventListener('beforeprint', print);
  addEventListener('afterprint', print);
  return {
    element,
    canvas,
    geometry: () => geometry,
    palette: () => palette,
    resize(other) {
      size = other;
      measure();
    },
    redraw,
    now,
    describe(text) {
      if (canvas.getAttribute('aria-label') !== text) canvas.setAttribute('aria-label', text);
    },
    close() {
      cancelAnimationFrame(waiting);
      observer.disconnect();
      unwatch();
      removeEventListener('resize', measure);
      removeEventListener('beforeprint', print);
      removeEventListener('afterprint', print);
    },
  };
}
