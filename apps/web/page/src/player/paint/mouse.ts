// What moves: the mouse and the rays of its sensors. Painted in every frame of the browser, and makes nothing anew.
import { halfX, halfY, type Geometry } from '../../maze/geometry';
import type { Context } from '../../maze/painter';
import type { Pose } from '../motion';
import { thick, type Brush } from './brush';

/** The outline of a mouse of one cell that looks north: a dart. */
function traceMouse(context: Context, size: number) {
  context.beginPath();
  context.moveTo(0, -0.36 * size);
  context.lineTo(0.28 * size, 0.31 * size);
  context.lineTo(0, 0.2 * size);
  context.lineTo(-0.28 * size, 0.31 * size);
  context.closePath();
}

/** `size` 1 for one that fills its cell. */
export function paintMouse({ context, g, palette, hue }: Brush, pose: Pose, size = 1) {
  const angle = (pose[2] * Math.PI) / 4;
  const cos = Math.cos(angle);
  const sin = Math.sin(angle);
  context.setTransform(cos, sin, -sin, cos, halfX(g, pose[0]), halfY(g, pose[1]));
  traceMouse(context, Math.max(g.pitch * size, 10 * g.ratio));
  context.lineJoin = 'round';
  context.lineWidth = thick(g, 0.07);
  context.strokeStyle = palette.paper;
  context.stroke();
  context.fillStyle = palette[hue];
  context.fill();
  context.setTransform(1, 0, 0, 1, 0, 0);
}

/** A ray over that many open cells, with a bar where it met a wall. `quarter`: 0 north, 1 east, 2 south, 3 west. */
function paintRay(context: Context, g: Geometry, x: number, y: number, quarter: number, open: number) {
  const width = thick(g, 0.05);
  const bar = thick(g, 0.3);
  const back = width >> 1;
  const length = open * g.pitch + (g.pitch >> 1) - g.wall;
  const end = length - width;
  if (quarter === 0) {
    context.fillRect(x - back, y - length, width, length);
    context.fillRect(x - (bar >> 1), y - length, bar, width);
  } else if (quarter === 2) {
    context.fillRect(x - back, y, width, length);
    context.fillRect(x - (bar >> 1), y + end, bar, width);
  } else if (quarter === 1) {
    context.fillRect(x, y - back, length, width);
    context.fillRect(x + end, y - (bar >> 1), width, bar);
  } else {
    context.fillRect(x - length, y - back, length, width);
    context.fillRect(x - length, y - (bar >> 1), width, bar);
  }
}

/** What the mouse read before the present step. */
export function paintRays({ context, g, palette, track, past }: Brush) {
  const { left, ahead, right } = track.play;
  const step = past.frame;
  if (step >= left.length) return;
  const x = Math.round(halfX(g, track.x[step]));
  const y = Math.round(halfY(g, track.y[step]));
  const quarter = (track.heading[step] >> 1) & 3;
  context.fillStyle = palette.muted;
  paintRay(context, g, x, y, (quarter + 3) & 3, left[step]);
  paintRay(context, g, x, y, quarter, ahead[step]);
  paintRay(context, g, x, y, (quarter + 1) & 3, right[step]);
}
