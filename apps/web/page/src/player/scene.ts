// One play on its canvas: what changes with the frame is painted on a canvas below, and only when it has changed; the
// mouse is painted on a copy of that in every frame of the browser.
import { h } from '../ui/dom';
import { paintGround, paintLetters, paintNumbers } from '../maze/painter';
import type { Tone } from '../maze/palette';
import { createStage, type Stage, type StageOptions } from '../maze/stage';
import { createMoment, goTo, type Moment } from './drive';
import type { Layers } from './layers';
import { createPose, poseAt } from './motion';
import type { Brush } from './paint/brush';
import { paintCandidates } from './paint/candidates';
import { distanceOf, paintDistances } from './paint/distances';
import { paintDriven, paintDriving, paintFastest, poseOf } from './paint/drive';
import { paintFloor } from './paint/floor';
import { paintMouse, paintRays } from './paint/mouse';
import { cellAtFrame, paintPlan } from './paint/plan';
import { paintMmsTexts } from './paint/mms-texts';
import { paintBest, paintExploration, paintSpeedRun } from './paint/ways';
import { paintWalls } from './paint/walls';
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
  believes(): boolean;
  /** Goes to that time and paints what changed; `smooth` between the frames. Says whether the frame changed. */
  show(time: number, smooth: boolean): boolean;
  /** Steps to the goal from that cell, as the layer of distances has them (true where it is off); -1 for no way. */
  distanceOf(cell: number): number;
  /** The cell in which the mouse is. */
  cell(): number;
  /** After the layers have changed. */
  repaint(): void;
}

/** Of a cell: paths between posts are to be seen. */
const mouseInSeconds = 0.6;

/** Everything but the mouse and its rays. */
function paintBelow(brush: Brush) {
  const { context, g, palette, track, layers } = brush;
  const mms = track.play.world === 'mms';
  const crowded = layers.exploration || layers.speed || layers.distances !== 'none' || mms;
  paintGround(context, g, palette);
  paintFloor(brush);
  paintLetters(context, g, palette, track.maze, crowded);
  paintWalls(brush);
  if (layers.best) (track.drive ? paintFastest : paintBest)(brush);
  if (layers.exploration && !track.drive) paintExploration(brush);
  if (layers.speed) (track.drive ? paintDriven : paintSpeedRun)(brush);
  if (layers.mms && mms) paintMmsTexts(brush);
  if (layers.distances !== 'none') paintDistances(brush);
  if (layers.candidates) paintCandidates(brush);
  paintNumbers(context, g, palette);
}

export function createScene(track: Track, layers: Layers, options: SceneOptions = {}): Scene {
  const past = createPast(track);
  const pose = createPose();
  const moment = track.drive ? createMoment() : null;
  const belowCanvas = h('canvas');
  const context = belowCanvas.getContext('2d', { alpha: false })!;
  let below: Brush | null = null;
  let front: Brush | null = null;
  let beliefs: Uint16Array | null = null;
  let stale = true;
  let shown = -1;

  function paint() {
    if (!below || !front) return;
    if (stale) paintBelow(below);
    if (stale && options.plan && track.run[past.frame] === 0) paintPlan(below);
    stale = false;
    front.context.drawImage(belowCanvas, 0, 0);
    if (layers.rays) paintRays(front);
    if (layers.speed && moment) paintDriving(front, moment);
    paintMouse(front, pose, track.drive ? mouseInSeconds : 1);
  }
  const stage = createStage(track.maze, paint, {
    numbers: true,
    looked: options.looked,
    changed(g, palette) {
      if (belowCanvas.width !== g.canvasWidth) belowCanvas.width = g.canvasWidth;
      if (belowCanvas.height !== g.canvasHeight) belowCanvas.height = g.canvasHeight;
      below = { context, g, palette, track, past, layers, beliefs, hue: options.hue ?? 'ink' };
      front = { ...below, context: stage.canvas.getContext('2d', { alpha: false })! };
      stale = true;
    },
  });
  function look(time: number, frame: number, share: number) {
    poseAt(track, frame, share, pose);
    if (!track.drive || !moment) return;
    goTo(track.drive, time, moment);
    poseOf(moment, pose);
  }
  look(0, 0, 0);

  return {
    stage,
    track,
    past,
    moment,
    setBeliefs(other) {
      beliefs = other;
      if (below) below.beliefs = other;
      stale = true;
      stage.redraw();
    },
    believes: () => beliefs !== null,
    distanceOf: (cell) => (below ? distanceOf(below, cell) : -1),
    cell: () => cellAtFrame(track, past.frame),
    show(time, smooth) {
      const frame = frameAt(track, time);
      const changed = frame !== past.frame;
      if (changed) moveTo(past, frame);
      const between = smooth && frame < track.last ? track.time[frame + 1] - track.time[frame] : 0;
      const share = between > 0 ? (time - track.time[frame]) / between : 0;
      if (!changed && frame + share === shown) return false;
      shown = frame + share;
      look(smooth ? time : track.time[frame], frame, share);
      if (changed) stale = true;
      paint();
      return changed;
    },
    repaint() {
      stale = true;
      stage.redraw();
    },
  };
}
