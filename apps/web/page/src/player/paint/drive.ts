// The path of a mouse in seconds, coloured by its speed, and the fastest run that the maze allows.
import { halfX, halfY, type Geometry } from '../../maze/geometry';
import type { Context } from '../../maze/painter';
import type { Pose } from '../motion';
import { followsRoute, runAt, pointAt, type Course, type Moment } from '../drive';
import { thick, type Brush } from './brush';

/** The tone of a speed: 0 the slowest of so many, the last one the fastest. */
export function speedLevel(speed: number, fastest: number, levels: number): number {
  return Math.min(levels - 1, Math.max(0, Math.floor((speed / fastest) * levels)));
}

function to(context: Context, g: Geometry, { x, y }: Pick<Course, 'x' | 'y'>, point: number, begin: boolean) {
  if (begin) context.moveTo(halfX(g, 2 * x[point]), halfY(g, 2 * y[point]));
  else context.lineTo(halfX(g, 2 * x[point]), halfY(g, 2 * y[point]));
}

/** Strokes from point to point; pieces of one tone as one line. */
function stroke({ context, g, palette, track }: Brush, course: Course, from: number, last: number) {
  const { fastest } = track.drive!;
  const { speeds } = palette;
  const { t, v } = course;
  let level = -1;
  for (let i = from; i < last; ++i) {
    if (t[i + 1] <= t[i]) continue;
    const next = speedLevel((v[i] + v[i + 1]) / 2, fastest, speeds.length);
    if (next !== level) {
      if (level >= 0) context.stroke();
      level = next;
      context.strokeStyle = speeds[level];
      context.beginPath();
      to(context, g, course, i, true);
    }
    to(context, g, course, i + 1, false);
  }
  if (level >= 0) context.stroke();
}

function prepareLine({ context, g }: Brush) {
  context.lineCap = 'round';
  context.lineJoin = 'round';
  context.lineWidth = thick(g, 0.13);
}

/** What is driven of the present run by the present frame; what is still to come of a speed run as a faint line. */
export function paintDriven(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  const drive = track.drive!;
  const time = track.time[past.frame];
  const run = drive.runs[runAt(drive, time)];
  if (!run || run.to <= run.from) return;
  if (followsRoute(run)) {
    context.lineWidth = thick(g, 0.05);
    context.strokeStyle = palette.muted;
    context.beginPath();
    for (let i = run.from; i < run.to; ++i) to(context, g, drive.path, i, i === run.from);
    context.stroke();
  }
  prepareLine(brush);
  stroke(brush, drive.path, run.from, pointAt(drive, run, time));
}

/** What has been driven since the present frame. */
export function paintDriving(brush: Brush, moment: Moment) {
  const { context, g, palette, track, past } = brush;
  const drive = track.drive!;
  const run = drive.runs[moment.run];
  if (!run || moment.point < 0) return;
  const from = pointAt(drive, run, track.time[past.frame]);
  prepareLine(brush);
  stroke(brush, drive.path, from, moment.point);
  context.strokeStyle = palette.speeds[speedLevel(moment.v, drive.fastest, palette.speeds.length)];
  context.beginPath();
  to(context, g, drive.path, moment.point, true);
  context.lineTo(halfX(g, 2 * moment.x), halfY(g, 2 * moment.y));
  context.stroke();
}

const broken = [0, 0];
const solid: number[] = [];

/** The fastest possible run as a thin broken line. */
export function paintFastest({ context, g, palette, track }: Brush) {
  const { best } = track.drive!;
  broken[0] = broken[1] = Math.max(2, g.pitch * 0.12);
  context.setLineDash(broken);
  context.lineWidth = thick(g, 0.06);
  context.strokeStyle = palette.ink;
  context.beginPath();
  for (let i = 0; i < best.t.length; ++i) to(context, g, best, i, i === 0);
  context.stroke();
  context.setLineDash(solid);
}

/** Where the mouse is, in half cells, as paintMouse has it. */
export function poseOf(moment: Moment, pose: Pose) {
  if (moment.point < 0) return;
  pose[0] = 2 * moment.x;
  pose[1] = 2 * moment.y;
  pose[2] = moment.heading;
}
