// Both mice of a contest in the physical world: the true one with its beams, where it believes to be, what it read of the
// walls about it, and what it touched. Painted in every frame of the browser, and makes nothing anew.
import type { DriveBodies } from '../../core/types';
import { halfX, halfY, type Geometry } from '../../maze/geometry';
import type { Context } from '../../maze/painter';
import type { DriveTrack, Moment } from '../drive';
import { createPose, type Pose } from '../motion';
import { poseOf } from './drive';
import { thick, type Brush } from './brush';

/** Where it believes to be at that moment, in half cells and eighths of a turn; false where nobody knows. */
export function beliefAt({ path, runs }: DriveTrack, bodies: DriveBodies, moment: Moment, pose: Pose): boolean {
  const { point, time } = moment;
  const { x, y, heading } = bodies.belief;
  if (point < 0 || point >= x.length) return false;
  const last = point + 1 >= runs[moment.run].to;
  const span = last ? 0 : path.t[point + 1] - path.t[point];
  const share = span > 0 ? Math.min(Math.max((time - path.t[point]) / span, 0), 1) : 0;
  const between = (list: number[]) => (share > 0 ? list[point] + (list[point + 1] - list[point]) * share : list[point]);
  pose[0] = 2 * between(x);
  pose[1] = 2 * between(y);
  pose[2] = between(heading);
  return true;
}

/** The last of a list in the order of time by that moment; -1 for none. */
export function lastBy(list: { time: number }[], { time }: Moment): number {
  let i = list.length - 1;
  while (i >= 0 && list[i].time > time * 1e6) --i;
  return i;
}

/** Goes to a mouse: afterwards ahead is up, in device pixels. */
function goTo(context: Context, g: Geometry, pose: Pose) {
  const angle = (pose[2] * Math.PI) / 4;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  context.setTransform(cos, sin, -sin, cos, halfX(g, pose[0]), halfY(g, pose[1]));
}
const leave = (context: Context) => context.setTransform(1, 0, 0, 1, 0, 0);

function outline(context: Context, g: Geometry, { front, back, half_width: half, rounding }: DriveBodies) {
  context.beginPath();
  context.roundRect(
    -half * g.pitch,
    -front * g.pitch,
    2 * half * g.pitch,
    (front + back) * g.pitch,
    rounding * g.pitch,
  );
  context.stroke();
}

/** From each sensor to the wall that its reading says. */
function paintBeams(context: Context, g: Geometry, { beams, distances }: DriveBodies, point: number) {
  context.beginPath();
  for (let i = 0; i < beams.length; ++i) {
    const { ahead, left, angle } = beams[i];
    const distance = distances[point * beams.length + i] ?? 0;
    if (distance <= 0) continue;
    const way = (angle * Math.PI) / 4;
    context.moveTo(-left * g.pitch, -ahead * g.pitch);
    context.lineTo((-left + distance * Math.sin(way)) * g.pitch, (-ahead - distance * Math.cos(way)) * g.pitch);
  }
  context.stroke();
}

const sure = 64;

/** A bar on each side of the cell that it entered last: solid for a wall, broken for none, paler the less sure. */
function paintEvidence({ context, g, palette }: Brush, { x, y, heading, evidence }: DriveBodies['looks'][number]) {
  const middleX = halfX(g, 2 * x + 1);
  const middleY = halfY(g, 2 * y + 1);
  context.lineWidth = thick(g, 0.08);
  for (let i = 0; i < evidence.length; ++i) {
    if (evidence[i] === 0) continue;
    const way = ((heading + 2 * (i - 1)) * Math.PI) / 4;
    const [east, south] = [Math.sin(way), -Math.cos(way)];
    const [out, along] = [0.42 * g.pitch, 0.22 * g.pitch];
    context.globalAlpha = 0.25 + (0.75 * Math.min(Math.abs(evidence[i]), sure)) / sure;
    context.strokeStyle = evidence[i] > 0 ? palette.wrong : palette['to-goal'];
    context.beginPath();
    context.moveTo(middleX + out * east - along * south, middleY + out * south + along * east);
    context.lineTo(middleX + out * east + along * south, middleY + out * south - along * east);
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** A cross at each touch of this run so far; those of crashes are larger. */
function paintTouches({ context, g, palette, track }: Brush, bodies: DriveBodies, moment: Moment) {
  context.strokeStyle = palette.wrong;
  context.lineWidth = thick(g, 0.06);
  for (let i = lastBy(bodies.touches, moment); i >= 0; --i) {
    const { time, x, y, crash } = bodies.touches[i];
    if (time < track.drive!.runs[moment.run].begin) break;
    const arm = (crash ? 0.2 : 0.1) * g.pitch;
    const [atX, atY] = [halfX(g, 2 * x), halfY(g, 2 * y)];
    context.beginPath();
    context.moveTo(atX - arm, atY - arm);
    context.lineTo(atX + arm, atY + arm);
    context.moveTo(atX - arm, atY + arm);
    context.lineTo(atX + arm, atY - arm);
    context.stroke();
  }
}

const broken = [0, 0];
const solid: number[] = [];
const pose = createPose();

export function paintBodies(brush: Brush, moment: Moment) {
  const { context, g, palette, track } = brush;
  const drive = track.drive!;
  const { bodies } = drive.drive;
  if (!bodies || moment.point < 0) return;
  const look = lastBy(bodies.looks, moment);
  if (look >= 0) paintEvidence(brush, bodies.looks[look]);
  poseOf(moment, pose);
  goTo(context, g, pose);
  context.strokeStyle = palette.muted;
  context.lineWidth = thick(g, 0.03);
  paintBeams(context, g, bodies, moment.point);
  context.strokeStyle = palette[brush.hue];
  outline(context, g, bodies);
  if (beliefAt(drive, bodies, moment, pose)) {
    goTo(context, g, pose);
    broken[0] = broken[1] = Math.max(2, g.pitch * 0.06);
    context.setLineDash(broken);
    context.strokeStyle = palette.candidate;
    context.lineWidth = thick(g, 0.05);
    outline(context, g, bodies);
    context.setLineDash(solid);
  }
  leave(context);
  paintTouches(brush, bodies, moment);
}
