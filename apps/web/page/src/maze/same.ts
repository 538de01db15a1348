// Whether a thing is a maze, and whether two mazes are one.
import type { MazeData } from '../core/types';

/** Whether two plays are in one maze, whatever its name, so that they can be compared. */
export function isSameMaze({ maze: one }: { maze: MazeData }, { maze: other }: { maze: MazeData }): boolean {
  const sides = ({ width, height, walls, start, heading, goals }: MazeData) =>
    JSON.stringify([width, height, walls, start, heading, goals]);
  return sides(one) === sides(other);
}

export const isMaze = (thing: unknown): thing is MazeData =>
  typeof thing === 'object' && thing !== null && Array.isArray((thing as MazeData).walls);
