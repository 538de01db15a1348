// Layers that colour the floor. Plates leave a rim of what lies below them.
import { columnAt, rowAt } from '../../maze/geometry';
import { fillCell, paintPlates } from '../../maze/painter';
import { colourSlot } from '../mms-changes';
import { eachRun, thick, type Brush } from './brush';
import { paintDistanceTones } from './distances';
import { mmsColours } from './mms-colours';

/** Of a cell visited so often: 0 never, else 1 to `levels`, linear from one visit to the most. */
export function heatLevel(visits: number, most: number, levels: number): number {
  if (visits <= 1 || most <= 1) return visits > 0 ? 1 : 0;
  return 1 + Math.floor(((visits - 1) * (levels - 1)) / (most - 1));
}

function paintHeat({ context, g, palette, past, track }: Brush) {
  const { heat } = palette;
  const levelOf = (cell: number) => heatLevel(past.visits[cell], track.mostVisits, heat.length);
  for (let level = 1; level <= heat.length; ++level) {
    context.fillStyle = heat[level - 1];
    for (let y = 0; y < g.height; ++y)
      eachRun(
        g.width,
        (x) => levelOf(y * g.width + x) === level,
        (from, to) => context.fillRect(columnAt(g, from), rowAt(g, y + 1), (to - from) * g.pitch, g.pitch),
      );
  }
}

function paintColours({ context, g, past, track }: Brush) {
  const rim = thick(g, 0.1);
  for (let cell = 0; cell < track.cells; ++cell) {
    const colour = past.drawn[colourSlot(track.cells, cell)];
    if (colour === 0) continue;
    context.fillStyle = mmsColours[colour - 1].fill;
    fillCell(context, g, cell % g.width, Math.floor(cell / g.width), rim);
  }
}

export function paintFloor(brush: Brush) {
  const { context, g, palette, track, layers } = brush;
  if (layers.visits) paintHeat(brush);
  if (layers.distances !== 'none') paintDistanceTones(brush);
  paintPlates(context, g, palette, track.maze, layers.visits ? thick(g, 0.1) : 0);
  if (layers.mms && track.play.traits.draws) paintColours(brush);
}
