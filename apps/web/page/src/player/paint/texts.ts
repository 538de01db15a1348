// Layers of small writing: distances, and the texts of programs for mms.
import { fontOf, textOf } from '../../maze/fonts';
import { columnAt, rowAt } from '../../maze/geometry';
import type { Context } from '../../maze/painter';
import { colourSlot, textSlot } from '../mms-changes';
import type { Brush } from './brush';
import { mmsColours } from './mms-colours';

const noWay = 65535;

/** Writing with a rim of paper, to be read on lines. */
function write(context: Context, text: string, x: number, y: number, rimmed: boolean) {
  if (rimmed) context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

/** Whether writing of that size can be read. */
function prepare(brush: Brush, size: number): boolean {
  const { context, g, palette } = brush;
  context.font = fontOf(palette, size);
  context.fillStyle = palette.ink;
  context.strokeStyle = palette.paper;
  context.lineWidth = Math.max(2, Math.round(size * 0.25));
  context.lineJoin = 'round';
  context.textBaseline = 'middle';
  return size >= 4.5 * g.ratio;
}

/** In the middle of cells, or in the lower right corner where lines pass. */
export function paintDistances(brush: Brush) {
  const { context, g, track, past, layers, beliefs } = brush;
  const believed = layers.distances === 'believed';
  if (believed && !beliefs) return;
  const lined = layers.exploration || layers.best || (layers.speed && track.resetFrame >= 0);
  if (!prepare(brush, Math.round(g.pitch * (lined ? 0.28 : 0.34)))) return;
  context.textAlign = lined ? 'right' : 'center';
  const across = g.pitch * (lined ? 0.9 : 0.5);
  const down = g.pitch * (lined ? 0.78 : 0.5);
  for (let cell = 0; cell < track.cells; ++cell) {
    const distance = believed ? beliefs![past.frame * track.cells + cell] : track.play.distances[cell];
    if (distance < 0 || distance === noWay || distance === undefined) continue;
    const x = columnAt(g, cell % g.width) + across;
    write(context, textOf(distance), x, rowAt(g, Math.floor(cell / g.width) + 1) + down, true);
  }
}

/** Two rows of five characters a cell, as mms shows them. */
export function paintMmsTexts(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  if (!prepare(brush, Math.round(g.pitch * 0.24))) return;
  context.textAlign = 'center';
  for (let cell = 0; cell < track.cells; ++cell) {
    const text = track.changes.rows[past.drawn[textSlot(track.cells, cell)]];
    if (text.length === 0) continue;
    const colour = past.drawn[colourSlot(track.cells, cell)];
    context.fillStyle = colour > 0 ? mmsColours[colour - 1].text : palette.ink;
    const x = columnAt(g, cell % g.width) + g.pitch / 2;
    const y = rowAt(g, Math.floor(cell / g.width) + 1) + g.pitch / 2;
    const up = text.length > 1 ? g.pitch * 0.15 : 0;
    write(context, text[0], x, y - up, false);
    if (text.length > 1) write(context, text[1], x, y + up, false);
  }
}
