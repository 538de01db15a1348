// A canvas for a maze that is as large as its place allows, crisp at every zoom of the browser, and can be looked at closer.
import { h } from '../ui/dom';
import { onTones, paperWidth } from '../ui/tones';
import { cameraOf, closest, seenThrough, wholeMaze, zoomed, type Camera } from './camera';
import { bare, fit, numbered, type Geometry, type MazeSize } from './geometry';
import { listenForGestures, type Gestures } from './gestures';
import { readPalette, type Palette } from './palette';
import type { Context } from './painter';

/** Device pixels to a pixel of the page, at least, while it is printed. */
const printRatio = 3;

export interface Stage {
  /** Its room, which the style sheets give it; the canvas in it has role=img. */
  element: HTMLElement;
  canvas: HTMLCanvasElement;
  geometry(): Geometry;
  palette(): Palette;
  /** For another maze, which is seen as a whole. */
  resize(maze: MazeSize): void;
  /** Paints before the next frame of the browser, however often it is called; `now` at once. */
  redraw(): void;
  now(): void;
  camera(): Camera;
  /** Looks at it from there; nobody is told. */
  look(camera: Camera): void;
  /** Nearer by that factor, around a place of the canvas or its middle. */
  zoomBy(factor: number, x?: number, y?: number): void;
  /** Aside, in pixels of the page. */
  panBy(x: number, y: number): void;
  whole(): void;
  /** What the picture shows, for those who do not see it. */
  describe(text: string): void;
  close(): void;
}

export interface StageOptions extends Partial<Gestures> {
  /** Numbers of columns and rows beside the maze need room. */
  numbers?: boolean;
  /** Called after the geometry or the palette has changed, before `paint`. */
  changed?: (geometry: Geometry, palette: Palette) => void;
  /** The user looks at it from somewhere else. */
  looked?: (camera: Camera) => void;
}

export function createStage(
  maze: MazeSize,
  paint: (context: Context, geometry: Geometry, palette: Palette) => void,
  options: StageOptions = {},
): Stage {
  const canvas = h('canvas', { role: 'img', 'aria-label': 'No maze yet' });
  const element = h('div', { class: 'stage' }, canvas);
  const context = canvas.getContext('2d', { alpha: false })!;
  const margins = options.numbers ? numbered : bare;
  let size = maze;
  let palette = readPalette();
  let fitted = fit(size, 300, 300, 1, margins);
  let geometry = fitted;
  let camera = wholeMaze(size);
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
  /** What the camera shows of a room, in pixels of the page. */
  function seen(width: number, height: number, ratio: number): Geometry {
    if (camera.scale === 1 || printing) return fitted;
    const room = { width: Math.floor(width * ratio), height: Math.floor(height * ratio) };
    const close = seenThrough(camera, fitted, room, margins);
    camera = cameraOf(camera.scale, close);
    return close;
  }
  function measure() {
    const { clientWidth, clientHeight } = element;
    const paper = printing ? paperWidth() : null;
    const [width, height] = paper ? [paper, paper] : [clientWidth, clientHeight];
    if (width === 0 || height === 0) return;
    const ratio = printing ? Math.max(printRatio, devicePixelRatio) : devicePixelRatio;
    fitted = fit(size, width, height, ratio, margins);
    geometry = seen(width, height, ratio);
    if (canvas.width !== geometry.canvasWidth || canvas.height !== geometry.canvasHeight) {
      canvas.width = geometry.canvasWidth;
      canvas.height = geometry.canvasHeight;
    }
    canvas.style.width = `${geometry.canvasWidth / ratio}px`;
    canvas.style.height = `${geometry.canvasHeight / ratio}px`;
    element.classList.toggle('close', camera.scale > 1);
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
  function look(next: Camera) {
    camera = next.scale > 1.001 ? next : wholeMaze(size);
    measure();
  }
  function move(next: Camera) {
    look(next);
    options.looked?.(camera);
  }
  const looking = {
    scale: () => camera.scale,
    zoomBy(factor: number, x = canvas.clientWidth / 2, y = canvas.clientHeight / 2) {
      const g = geometry;
      const column = (x * g.ratio - g.left) / g.pitch;
      const row = g.height - (y * g.ratio - g.top) / g.pitch;
      // What the whole maze leaves free beside it is room for a closer look: its middle is where the room's is.
      move(zoomed(cameraOf(camera.scale, g), factor, closest(fitted), [column, row]));
    },
    panBy(x: number, y: number) {
      if (camera.scale === 1) return;
      const cell = geometry.pitch / geometry.ratio;
      move({ ...camera, x: camera.x - x / cell, y: camera.y + y / cell });
    },
  };
  listenForGestures(canvas, looking, {
    mayDrag: options.mayDrag ?? (({ button }) => button <= 1 && camera.scale > 1),
    twoFingers: options.twoFingers,
  });

  const observer = new ResizeObserver(measure);
  observer.observe(element);
  // Another zoom of the browser can leave the room as large as it was.
  addEventListener('resize', measure);
  const unwatch = onTones(recolour);
  addEventListener('beforeprint', print);
  addEventListener('afterprint', print);
  return {
    element,
    canvas,
    geometry: () => geometry,
    palette: () => palette,
    resize(other) {
      size = other;
      camera = wholeMaze(size);
      measure();
    },
    redraw,
    now,
    camera: () => camera,
    look,
    zoomBy: looking.zoomBy,
    panBy: looking.panBy,
    whole: () => move(wholeMaze(size)),
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
