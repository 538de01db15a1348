// The layer of distances: numbers, or tones where the cells are too small for numbers.
import { textOf } from '../../maze/fonts';
import { columnAt, rowAt } from '../../maze/geometry';
import { fillCell } from '../../maze/painter';
import type { Brush } from './brush';
import { prepareWriting } from './writing';

const noWay = 65535;
const levels = 8;

/** Whether numbers in the cells could not be read. */
const tooSmall = ({ g }: Brush) => g.pitch < 22 * g.ratio;

/** Steps to the goal from a cell, true or believed; -1 for no way, and while the beliefs are not there yet. */
export function distanceOf({ track, past, layers, beliefs }: Brush, cell: number): number {
  if (layers.distances !== 'believed') return track.play.distances[cell] ?? -1;
  const distance = beliefs ? beliefs[past.frame * track.cells + cell] : noWay;
  return distance === noWay ? -1 : distance;
}

/** The nearer to the goal, the stronger. */
export function paintDistanceTones(brush: Brush) {
  const { context, g, palette, track } = brush;
  if (!tooSmall(brush)) return;
  let most = 1;
  for (let cell = 0; cell < track.cells; ++cell) most = Math.max(most, distanceOf(brush, cell));
  context.fillStyle = palette.onwards;
  for (let cell = 0; cell < track.cells; ++cell) {
    const distance = distanceOf(brush, cell);
    if (distance < 0) continue;
    context.globalAlpha = (levels - Math.floor(((levels - 1) * distance) / most)) * 0.08;
    fillCell(context, g, cell % g.width, Math.floor(cell / g.width));
  }
  context.globalAlpha = 1;
}

/** In the middle of cells, or in the lower right corner where lines pass. */
export function paintDistances(brush: Brush) {
  const { context, g, track, layers } = brush;
  if (tooSmall(brush)) return;
  const lined = layers.search || layers.best || (layers.speed && track.resetFrame >= 0);
  prepareWriting(brush, Math.round(g.pitch * (lined ? 0.28 : 0.34)));
  context.textAlign = lined ? 'right' : 'center';
  const across = Math.round(g.pitch * (lined ? 0.9 : 0.5));
  const down = Math.round(g.pitch * (lined ? 0.78 : 0.52));
  for (let cell = 0; cell < track.cells; ++cell) {
    const distance = distanceOf(brush, cell);
    if (distance < 0) continue;
    const x = columnAt(g, cell % g.width) + across;
    const y = rowAt(g, Math.floor(cell / g.width) + 1) + down;
    context.strokeText(textOf(distance), x, y);
    context.fillText(textOf(distance), x, y);
  }
}
