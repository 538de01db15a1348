// Pieces of ways: each goes from a point of the half cells to one beside it, and has a place in a list, whichever way
// it is gone: 4 * point + direction, from its western (or southern) end.
import type { MazeSize } from '../maze/geometry';

const directions = [
  [0, 1],
  [1, 1],
  [1, 0],
  [1, -1],
] as const;

/** How far a piece of that direction goes, in half cells. */
export const pieceX = Int8Array.from(directions, ([dx]) => dx);
export const pieceY = Int8Array.from(directions, ([, dy]) => dy);

export const waySlots = ({ width, height }: MazeSize) => 4 * (2 * width + 1) * (2 * height + 1);

/** Of a piece that goes east, or straight north. */
export const directionOf = (dx: number, dy: number) => (dx === 0 ? 0 : 2 - dy);
