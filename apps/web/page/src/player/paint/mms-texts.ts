// The texts of programs for mms: two rows of five characters a cell, as mms shows them.
import { columnAt, rowAt } from '../../maze/geometry';
import { colourSlot, textSlot } from '../mms-changes';
import type { Brush } from './brush';
import { mmsColours } from './mms-colours';
import { prepareWriting } from './writing';

export function paintMmsTexts(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  const size = Math.round(g.pitch * 0.24);
  if (size < 5 * g.ratio) return;
  prepareWriting(brush, size);
  context.textAlign = 'center';
  for (let cell = 0; cell < track.cells; ++cell) {
    const rows = track.changes.rows[past.drawn[textSlot(track.cells, cell)]];
    if (rows.length === 0) continue;
    const colour = past.drawn[colourSlot(track.cells, cell)];
    context.fillStyle = colour > 0 ? mmsColours[colour - 1].text : palette.ink;
    const x = columnAt(g, cell % g.width) + Math.round(g.pitch / 2);
    const y = rowAt(g, Math.floor(cell / g.width) + 1) + Math.round(g.pitch / 2);
    const up = rows.length > 1 ? Math.round(g.pitch * 0.15) : 0;
    context.fillText(rows[0], x, y - up);
    if (rows.length > 1) context.fillText(rows[1], x, y + up);
  }
}
