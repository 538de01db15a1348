// Layers of lines: the ways gone so far, the speed run with its strides, the best possible run.
import { fontOf, textOf } from '../../maze/fonts';
import { halfX, halfY } from '../../maze/geometry';
import { onwards, speedRun, toGoal } from '../past';
import { pieceX, pieceY } from '../ways';
import { thick, type Brush } from './brush';

/** Traces all pieces of a way that were gone. */
function tracePieces({ context, g, past }: Brush, category: number, shift: number) {
  const counts = past.ways[category];
  const wide = 2 * g.width + 1;
  context.beginPath();
  for (let i = 0; i < counts.length; ++i) {
    if (counts[i] === 0) continue;
    const direction = i & 3;
    const x = (i >> 2) % wide;
    const y = Math.floor((i >> 2) / wide);
    context.moveTo(halfX(g, x) + shift, halfY(g, y) + shift);
    context.lineTo(halfX(g, x + pieceX[direction]) + shift, halfY(g, y + pieceY[direction]) + shift);
  }
}

const solid: number[] = [];
const broken = [0, 0];

/** Both ways of the search run, beside each other; the second one broken, so that not only its colour tells it. */
export function paintSearchRun(brush: Brush) {
  const { context, g, palette } = brush;
  const lane = Math.round(g.pitch * 0.07);
  context.lineWidth = thick(g, 0.08);
  context.lineCap = 'butt';
  broken[0] = g.pitch * 0.3;
  broken[1] = g.pitch * 0.2;
  context.setLineDash(broken);
  context.strokeStyle = palette.onwards;
  tracePieces(brush, onwards, lane);
  context.stroke();
  context.setLineDash(solid);
  context.lineCap = 'round';
  context.strokeStyle = palette['to-goal'];
  tracePieces(brush, toGoal, -lane);
  context.stroke();
}

function paintStop(brush: Brush, frame: number) {
  const { context, g, palette, track } = brush;
  const fan = track.fan[frame] * Math.round(g.pitch * 0.08);
  const x = halfX(g, track.x[frame]) + fan;
  const y = halfY(g, track.y[frame]) + fan;
  context.beginPath();
  context.arc(x, y, g.pitch * 0.24, 0, 2 * Math.PI);
  context.fillStyle = palette.route;
  context.fill();
  context.stroke();
  const step = track.speed[frame];
  const size = Math.round(g.pitch * (step < 100 ? 0.27 : 0.2));
  if (size < 5 * g.ratio) return;
  context.font = fontOf(palette, size, 600);
  context.fillStyle = palette.paper;
  context.fillText(textOf(step), x, y + Math.round(size * 0.06));
}

/** Traces the whole speed run from that frame on. */
function traceRun({ context, g, track }: Brush, from: number) {
  context.beginPath();
  for (let frame = from; frame <= track.last; ++frame) {
    const x = halfX(g, track.x[frame]);
    const y = halfY(g, track.y[frame]);
    if (frame === from || track.jump[frame - 1] !== 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
}

/**
 * What was run strongly, with a dot at the end of each step; what is still to be run faintly.
 * Dots of stops in the same place fan out like cards.
 */
export function paintSpeedRun(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  if (track.resetFrame < 0 || past.frame < track.resetFrame) return;
  context.lineCap = 'round';
  context.lineJoin = 'round';
  context.lineWidth = thick(g, 0.12);
  context.strokeStyle = palette.route;
  context.globalAlpha = 0.3;
  traceRun(brush, past.frame);
  context.stroke();
  context.globalAlpha = 0.85;
  tracePieces(brush, speedRun, 0);
  context.stroke();
  context.globalAlpha = 1;
  context.lineWidth = thick(g, 0.03);
  context.strokeStyle = palette.paper;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  for (let frame = track.resetFrame + 1; frame <= past.frame; ++frame) paintStop(brush, frame);
}

/** A best possible run as a thin line with a ring at the end of each step. */
export function paintBest({ context, g, palette, track }: Brush) {
  const { route } = track.play;
  const radius = Math.max(2, Math.round(g.pitch * 0.12));
  context.lineWidth = thick(g, 0.05);
  context.strokeStyle = palette.muted;
  context.lineCap = 'butt';
  context.beginPath();
  for (let i = 0; i + 1 < route.length; ++i) {
    const x = Math.round(halfX(g, 2 * route[i][0] + 1));
    const y = Math.round(halfY(g, 2 * route[i][1] + 1));
    const nextX = Math.round(halfX(g, 2 * route[i + 1][0] + 1));
    const nextY = Math.round(halfY(g, 2 * route[i + 1][1] + 1));
    context.moveTo(x + Math.sign(nextX - x) * radius, y + Math.sign(nextY - y) * radius);
    context.lineTo(nextX - Math.sign(nextX - x) * radius, nextY - Math.sign(nextY - y) * radius);
    context.moveTo(nextX + radius, nextY);
    context.arc(nextX, nextY, radius, 0, 2 * Math.PI);
  }
  context.stroke();
}
