// The layer that shows among which walls the mouse chose.
import type { Candidate } from '../../core/types';
import { fontOf } from '../../maze/fonts';
import { columnAt, rowAt, type Geometry } from '../../maze/geometry';
import { fillWall } from '../../maze/painter';
import { thick, type Brush } from './brush';

/** Where its number stands: in the middle of the wall, or of the goal's lower edge. */
function middleX(g: Geometry, { wall, seen_from: [x] }: Candidate): number {
  if (wall) return wall[2] === 'east' ? columnAt(g, wall[0] + 1) : columnAt(g, wall[0]) + g.pitch / 2;
  return columnAt(g, x) + g.pitch / 2;
}
function middleY(g: Geometry, { wall, seen_from: [, y] }: Candidate): number {
  if (wall) return wall[2] === 'east' ? rowAt(g, wall[1]) - g.pitch / 2 : rowAt(g, wall[1] + 1);
  return rowAt(g, y) - Math.round(g.pitch * 0.15);
}

function paintMark({ context, g, palette }: Brush, candidate: Candidate, thickness: number) {
  if (candidate.wall) {
    const index = candidate.wall[1] * g.width + candidate.wall[0];
    fillWall(context, g, index + (candidate.wall[2] === 'east' ? g.width * g.height : 0), thickness);
    return;
  }
  const rim = Math.round(g.pitch * 0.15);
  const side = g.pitch - 2 * rim;
  context.lineWidth = thickness;
  context.strokeStyle = palette.candidate;
  context.strokeRect(columnAt(g, candidate.seen_from[0]) + rim, rowAt(g, candidate.seen_from[1] + 1) + rim, side, side);
}

/** What the candidates of that choice promise, in words; each made once. */
function labelsOf({ track }: Brush, at: number): string[] {
  return (track.labels[at] ??= track.play.reasons[at].candidates.map(({ through }) => through.toFixed(1)));
}

function paintNumber(brush: Brush, candidate: Candidate, text: string, chosen: boolean) {
  const { context, g, palette } = brush;
  context.font = fontOf(palette, Math.round(Math.max(g.pitch * 0.25, 7.5 * g.ratio)), chosen ? 700 : 400);
  const x = middleX(g, candidate);
  const y = middleY(g, candidate);
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

/** The candidates of the last choice: their walls, the chosen one the strongest, and the runs that they promise. */
export function paintCandidates(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  const at = track.reasons[past.frame];
  if (at < 0) return;
  const { candidates, chosen } = track.play.reasons[at];
  context.fillStyle = palette.candidate;
  for (let i = 0; i < candidates.length; ++i) {
    context.globalAlpha = i === chosen ? 1 : candidates[i].worth ? 0.75 : 0.4;
    paintMark(brush, candidates[i], i === chosen ? thick(g, 0.2) : thick(g, 0.09));
  }
  context.globalAlpha = 1;
  context.fillStyle = palette.ink;
  context.strokeStyle = palette.paper;
  context.lineWidth = Math.round(3 * g.ratio);
  context.lineJoin = 'round';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const all = g.pitch >= 26 * g.ratio;
  const labels = labelsOf(brush, at);
  for (let i = 0; i < candidates.length; ++i)
    if (i !== chosen && all) paintNumber(brush, candidates[i], labels[i], false);
  if (chosen >= 0) paintNumber(brush, candidates[chosen], labels[chosen], true);
}
