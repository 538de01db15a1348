// Where a mouse that assumes all unknown walls to be open would go from here: the way that it believes in.
import { halfX, halfY, wallIndex } from '../../maze/geometry';
import type { HeadingName } from '../../core/types';
import { knows } from '../past';
import type { Track } from '../track';
import { thick, type Brush } from './brush';

const sides: [HeadingName, number, number][] = [
  ['north', 0, 1],
  ['east', 1, 0],
  ['south', 0, -1],
  ['west', -1, 0],
];
const noWay = 65535;

/** The cell in which the mouse is in a frame. */
export function cellAtFrame({ x, y, maze: { width, height } }: Track, frame: number): number {
  const place = (half: number, most: number) => Math.min(Math.max(Math.floor(half / 2), 0), most - 1);
  return place(y[frame], height) * width + place(x[frame], width);
}

/** The cells of that way, from the mouse's own to a goal; empty while nothing is known of beliefs. */
export function plannedWay({ track, past, beliefs, g }: Pick<Brush, 'track' | 'past' | 'beliefs' | 'g'>): number[] {
  const { width } = g;
  if (!beliefs) return [];
  const believed = (cell: number) => beliefs[past.frame * track.cells + cell];
  let cell = cellAtFrame(track, past.frame);
  const way = [cell];
  while (believed(cell) > 0 && believed(cell) !== noWay) {
    const next = sides
      .filter(([side, dx]) => {
        const x = (cell % width) + dx;
        const wall = wallIndex(g, [cell % width, Math.floor(cell / width)], side);
        return x >= 0 && x < width && wall >= 0 && !(track.closed[wall] && knows(past, wall));
      })
      .map(([, dx, dy]) => cell + dx + dy * width)
      .find((other) => other >= 0 && other < track.cells && believed(other) < believed(cell));
    if (next === undefined) break;
    way.push((cell = next));
  }
  return way;
}

/** As a dotted line in the mouse's own tone. */
export function paintPlan(brush: Brush) {
  const { context, g } = brush;
  const whole = plannedWay(brush);
  // From where the present step ends: the mouse is on its way there.
  const { track, past } = brush;
  const ends = whole.indexOf(cellAtFrame(track, Math.min(past.frame + 1, track.last)));
  const way = whole.slice(Math.max(ends, 0));
  if (way.length < 2) return;
  context.strokeStyle = brush.palette[brush.hue];
  context.lineWidth = thick(g, 0.12);
  context.lineCap = 'round';
  context.setLineDash([0, g.pitch * 0.25]);
  context.beginPath();
  for (const cell of way)
    context.lineTo(halfX(g, 2 * (cell % g.width) + 1), halfY(g, 2 * Math.floor(cell / g.width) + 1));
  context.stroke();
  context.setLineDash([]);
}
