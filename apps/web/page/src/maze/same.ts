// Whether two mazes are one.
import type { MazeData } from '../core/types';

/** Whether two plays are in one maze, whatever its name, so that they can be compared. */
export function isSameMaze({ maze: one }: { maze: MazeData }, { maze: other }: { maze: MazeData }): boolean {
  const sides = ({ width, height, walls, start, heading, goals }: MazeData) =>
    JSON.stringify([width, height, walls, start, heading, goals]);
  return sides(one) === sides(other);
}
