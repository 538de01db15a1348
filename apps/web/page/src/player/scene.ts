// One play on its canvas: what changes with the frame is painted on a canvas below, and only when it has changed; the
// mouse is painted on a copy of that in every frame of the browser.
import type { Geometry } from '../maze/geometry';
import type { Tone } from '../maze/palette';
import { createStage, type Stage, type StageOptions } from '../maze/stage';
import type { Moment } from './drive';
import type { Layers } from './layers';
import type { Brush } from './paint/brush';
import { distanceOf } from './paint/distances';
import { cellAtFrame } from './paint/plan';
import { createPlace, paintAbove, paintBelow } from './painting';
import { createPast, moveTo, type Past } from './past';
import { frameAt, type Track } from './track';

export interface SceneOptions {
  looked?: StageOptions['looked'];
  /** The tone of the mouse; ink where it is missing. */
  hue?: Tone;
  /** Whether the way that the mouse believes in is drawn while it searches; for that it needs its beliefs. */
  plan?: boolean;
}

export interface Scene {
  stage: Stage;
  track: Track;
  past: Past;
  /** Of the last time that was shown; null in other worlds than that of seconds. */
  moment: Moment | null;
  /** Believed distances: see beliefs.ts. */
  setBeliefs(beliefs: Uint16Array): void;
  /** Null while there are none. */
  beliefs(): Uint16Array | null;
  /** Goes to that time and paints what changed; `smooth` between the frames. Says whether the frame changed. */
  show(time: number, smooth: boolean): boolean;
  /** Steps to the goal from that cell, as the layer of distances has them (true where it is off); -1 for no way. */
  distanceOf(cell: number): number;
  /** The cell in which the mouse is. */
  cell(): number;
  /** After the layers have changed. */
  repaint(): void;
}

/** How far that time is between that frame and the next one, from 0 to 1. */
export function shareOf({ time: times, last }: Track, frame: number, time: number): number {
  const between = frame < last ? times[frame + 1] - times[frame] : 0;
  return between > 0 ? (time - times[frame]) / between : 0;
}

/** Setting a size clears a canvas, so it is set where it changes alone. */
function setSize(canvas: HTMLCanvasElement, { canvasWidth, canvasHeight }: Geometry) {
  if (canvas.width !== canvasWidth) canvas.width = canvasWidth;
  if (canvas.height !== canvasHeight) canvas.height = canvasHeight;
}

export function createScene(track: Track, layers: Layers, options: SceneOptions = {}): Scene {
  const past = createPast(track);
  const place = createPlace(track);
  const context = document.createElement('canvas').getContext('2d', { alpha: false })!;
  let below: Brush | null = null;
  let front: Brush | null = null;
  let beliefs: Uint16Array | null = null;
  let [stale, shown] = [true, -1];

  function paint() {
    if (!below || !front) return;
    if (stale) paintBelow(below, options.plan);
    stale = false;
    front.context.drawImage(context.canvas, 0, 0);
    paintAbove(front, place);
  }
  const stage = createStage(track.maze, paint, {
    numbers: true,
    looked: options.looked,
    changed(g, palette) {
      setSize(context.canvas, g);
      below = { context, g, palette, track, past, layers, beliefs, hue: options.hue ?? 'ink' };
      front = { ...below, context: stage.canvas.getContext('2d', { alpha: false })! };
      stale = true;
    },
  });
  const repaint = () => ((stale = true), stage.redraw());
  place.look(0, 0, 0);

  return {
    stage,
    track,
    past,
    moment: place.moment,
    setBeliefs(other) {
      beliefs = other;
      if (below) below.beliefs = other;
      repaint();
    },
    beliefs: () => beliefs,
    distanceOf: (cell) => (below ? distanceOf(below, cell) : -1),
    cell: () => cellAtFrame(track, past.frame),
    repaint,
    show(time, smooth) {
      const frame = frameAt(track, time);
      const changed = frame !== past.frame;
      if (changed) moveTo(past, frame);
      const share = smooth ? shareOf(track, frame, time) : 0;
      if (!changed && frame + share === shown) return false;
      shown = frame + share;
      place.look(smooth ? time : track.time[frame], frame, share);
      if (changed) stale = true;
      paint();
      return changed;
    },
  };
}
