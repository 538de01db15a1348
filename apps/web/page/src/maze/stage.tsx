// A canvas for a maze that is as large as its place allows, crisp at every zoom of the browser, and can be looked at closer.
import type { ComponentProps } from 'preact';
import { onTones, paperWidth } from '../ui/tones';
import { cameraOf, closest, seenThrough, wholeMaze, zoomed, type Camera } from './camera';
import { bare, fit, numbered, type Geometry, type MazeSize } from './geometry';
import { listenForGestures, type Gestures } from './gestures';
import { readPalette, type Palette } from './palette';
import type { Context } from './painter';

/** Device pixels to a pixel of the page, at least, while it is printed. */
const printRatio = 3;

export type Stage = ReturnType<typeof createStage>;

export interface StageOptions extends Partial<Gestures> {
  /** Numbers of columns and rows beside the maze need room. */
  numbers?: boolean;
  /** Called after the geometry or the palette has changed, before `paint`. */
  changed?: (geometry: Geometry, palette: Palette) => void;
  /** The user looks at it from somewhere else. */
  looked?: (camera: Camera) => void;
}

type Paint = (context: Context, geometry: Geometry, palette: Palette) => void;

/** At once, or before the next frame of the browser, however often that is asked for. */
function createPainting(paint: () => void) {
  let waiting = 0;
  function now() {
    cancelAnimationFrame(waiting);
    waiting = 0;
    paint();
  }
  const redraw = () => void (waiting ||= requestAnimationFrame(now));
  return { now, redraw, cancel: () => cancelAnimationFrame(waiting) };
}

function createCanvas() {
  const canvas = document.createElement('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', 'No maze yet');
  return canvas;
}

/** Width and height of a room, or of a sheet of paper. */
function spaceIn(room: HTMLElement | null, printing: boolean): [number, number] {
  const paper = printing ? paperWidth() : null;
  return paper ? [paper, paper] : [room?.clientWidth ?? 0, room?.clientHeight ?? 0];
}

/** The canvas in its room: what is seen of a maze, at which size, in which tones. */
function createView(maze: MazeSize, paint: Paint, { numbers, changed }: StageOptions) {
  const canvas = createCanvas();
  let room: HTMLElement | null = null;
  const context = canvas.getContext('2d', { alpha: false })!;
  const margins = numbers ? numbered : bare;
  let palette = readPalette();
  let fitted = fit(maze, 300, 300, 1, margins);
  let geometry = fitted;
  let camera = wholeMaze(maze);
  let printing = false;
  const painting = createPainting(() => paint(context, geometry, palette));

  const paintChanged = () => (changed?.(geometry, palette), painting.now());
  function measure() {
    const [width, height] = spaceIn(room, printing);
    if (width === 0 || height === 0) return;
    const ratio = Math.max(printing ? printRatio : 0, devicePixelRatio);
    fitted = fit(maze, width, height, ratio, margins);
    geometry = fitted;
    if (camera.scale > 1 && !printing) {
      const [roomWidth, roomHeight] = [width, height].map((length) => Math.floor(length * ratio));
      geometry = seenThrough(camera, fitted, { width: roomWidth, height: roomHeight }, margins);
      camera = cameraOf(camera.scale, geometry);
    }
    setSize(canvas, geometry);
    room?.classList.toggle('close', camera.scale > 1);
    paintChanged();
  }
  return {
    canvas,
    /** Where it stands from now on. */
    setRoom: (next: HTMLElement | null) => void (room = next),
    geometry: () => geometry,
    palette: () => palette,
    camera: () => camera,
    /** How the whole maze lies. */
    fitted: () => fitted,
    ...painting,
    measure,
    print(is: boolean) {
      printing = is;
      palette = readPalette();
      measure();
    },
    look(next: Camera) {
      camera = next.scale > 1.001 ? next : wholeMaze(maze);
      measure();
    },
    resize(other: MazeSize) {
      maze = other;
      camera = wholeMaze(maze);
      measure();
    },
    recolour() {
      palette = readPalette();
      paintChanged();
    },
  };
}

type StageView = ReturnType<typeof createView>;

/** Crisp at every zoom of the browser. */
function setSize(canvas: HTMLCanvasElement, { canvasWidth, canvasHeight, ratio }: Geometry) {
  if (canvas.width !== canvasWidth || canvas.height !== canvasHeight) {
    canvas.width = canvasWidth;
    canvas.height = canvasHeight;
  }
  canvas.style.width = `${canvasWidth / ratio}px`;
  canvas.style.height = `${canvasHeight / ratio}px`;
}

/** How the user looks closer and aside. */
function lookingAt({ canvas, ...view }: StageView, move: (next: Camera) => void) {
  return {
    scale: () => view.camera().scale,
    zoomBy(factor: number, x = canvas.clientWidth / 2, y = canvas.clientHeight / 2) {
      const g = view.geometry();
      const column = (x * g.ratio - g.left) / g.pitch;
      const row = g.height - (y * g.ratio - g.top) / g.pitch;
      // What the whole maze leaves free beside it is room for a closer look: its middle is where the room's is.
      move(zoomed(cameraOf(view.camera().scale, g), factor, closest(view.fitted()), [column, row]));
    },
    panBy(x: number, y: number) {
      const camera = view.camera();
      if (camera.scale === 1) return;
      const { pitch, ratio } = view.geometry();
      const cell = pitch / ratio;
      move({ ...camera, x: camera.x - x / cell, y: camera.y + y / cell });
    },
  };
}

/** Measures again when the room, the zoom of the browser, the tones or the paper change; the function returned ends that. */
function watch(room: HTMLElement, { measure, recolour, ...view }: StageView): () => void {
  const print = ({ type }: Event) => view.print(type === 'beforeprint');
  const observer = new ResizeObserver(measure);
  observer.observe(room);
  // Another zoom of the browser can leave the room as large as it was.
  addEventListener('resize', measure);
  const unwatch = onTones(recolour);
  addEventListener('beforeprint', print);
  addEventListener('afterprint', print);
  return () => {
    observer.disconnect();
    unwatch();
    removeEventListener('resize', measure);
    removeEventListener('beforeprint', print);
    removeEventListener('afterprint', print);
  };
}

export function createStage(maze: MazeSize, paint: Paint, options: StageOptions = {}) {
  const view = createView(maze, paint, options);
  const { canvas, geometry, palette, camera, look, resize, redraw, now } = view;
  function move(next: Camera) {
    look(next);
    options.looked?.(camera());
  }
  const { zoomBy, panBy, scale } = lookingAt(view, move);
  listenForGestures(
    canvas,
    { scale, zoomBy, panBy },
    {
      mayDrag: options.mayDrag ?? (({ button }) => button <= 1 && camera().scale > 1),
      twoFingers: options.twoFingers,
    },
  );
  let leave = () => {};
  return {
    /** Takes its room, or leaves it where there is none; then it is painted no more. */
    enter(room: HTMLElement | null) {
      leave();
      view.setRoom(room);
      if (!room) return;
      room.prepend(canvas);
      const unwatch = watch(room, view);
      leave = () => {
        view.cancel();
        unwatch();
        canvas.remove();
      };
    },
    canvas,
    geometry,
    palette,
    /** For another maze, which is seen as a whole. */
    resize,
    /** Paints before the next frame of the browser, however often it is called; `now` at once. */
    redraw,
    now,
    camera,
    /** Looks at it from there; reports nothing. */
    look,
    /** Nearer by that factor, around a place of the canvas or its middle. */
    zoomBy,
    /** Aside, in pixels of the page. */
    panBy,
    whole: () => move({ ...camera(), scale: 1 }),
    /** What the picture shows, for those who do not see it. */
    describe(text: string) {
      if (canvas.getAttribute('aria-label') !== text) canvas.setAttribute('aria-label', text);
    },
  };
}

/** Its room, which the style sheets give its size; the canvas in it has role=img. */
export const StageRoom = ({ stage, ...more }: { stage: Stage } & ComponentProps<'div'>) => (
  <div class="stage" ref={stage.enter} {...more} />
);
