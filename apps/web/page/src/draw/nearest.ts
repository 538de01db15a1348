// What a pointer means. Places are in cells from the south-west corner, y northwards.
import type { Cell } from '../core/types';
import type { Wall } from './model';

/** Near a post it is not clear which of four walls is meant: the outer parts of a wall do not count. */
const post = 0.2;

/**
 * The inner wall that is nearest to a place and not farther than `reach` cells; null where there is none, and in the
 * middle of a cell.
 */
export function nearestWall(maze: { width: number; height: number }, x: number, y: number, reach = 0.3): Wall | null {
  const line = { x: Math.round(x), y: Math.round(y) };
  const away = { x: Math.abs(x - line.x), y: Math.abs(y - line.y) };
  const column = Math.floor(x);
  const row = Math.floor(y);
  if (x < 0 || y < 0 || column >= maze.width || row >= maze.height) return null;
  // Beside a vertical line x is near to a whole number, and y says how far it is to the posts.
  const vertical = away.x <= reach && away.y >= post && line.x > 0 && line.x < maze.width;
  const horizontal = away.y <= reach && away.x >= post && line.y > 0 && line.y < maze.height;
  if (vertical && (!horizontal || away.x <= away.y)) return { x: line.x - 1, y: row, side: 'east' };
  if (horizontal) return { x: column, y: line.y - 1, side: 'north' };
  return null;
}

/** The cell at a place, or null outside. */
export function cellAt(maze: { width: number; height: number }, x: number, y: number): Cell | null {
  const cell: Cell = [Math.floor(x), Math.floor(y)];
  return cell[0] >= 0 && cell[1] >= 0 && cell[0] < maze.width && cell[1] < maze.height ? cell : null;
}

/** Places on the way from one to another, close enough to miss no wall. */
export function between(from: [number, number], to: [number, number], step = 0.1): [number, number][] {
  const parts = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / step));
  return Array.from({ length: parts }, (_, i) => {
    const share = (i + 1) / parts;
    return [from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share];
  });
}
