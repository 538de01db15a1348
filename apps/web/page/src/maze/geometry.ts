// Where a maze lies on a canvas, in device pixels: a whole number of them to a cell, so that every wall is crisp.
import type { Cell, HeadingName, MazeData } from '../core/types';

export interface MazeSize {
  width: number;
  height: number;
}

export interface Geometry extends MazeSize {
  /** Device pixels from wall to wall, and of a wall's thickness. */
  pitch: number;
  wall: number;
  /** The middle of the north-western post. */
  left: number;
  top: number;
  canvasWidth: number;
  canvasHeight: number;
  /** Device pixels to a pixel of the page. */
  ratio: number;
}

/** Room around the maze, in pixels of the page. */
export interface Margins {
  left: number;
  bottom: number;
}

/** For the numbers of columns and rows. */
export const numbered: Margins = { left: 24, bottom: 18 };
export const bare: Margins = { left: 0, bottom: 0 };

const leastPitch = 3;

/** The largest maze that fits into so many pixels of the page. */
export function fit(maze: MazeSize, width: number, height: number, ratio: number, margins: Margins): Geometry {
  const across = Math.floor(width * ratio) - Math.round(margins.left * ratio);
  const down = Math.floor(height * ratio) - Math.round(margins.bottom * ratio);
  // A wall's thickness more than the cells, for both halves of the border.
  const share = 1 / 9;
  const pitch = Math.max(leastPitch, Math.floor(Math.min(across / (maze.width + share), down / (maze.height + share))));
  const wall = Math.max(1, Math.round(pitch * share));
  const rim = Math.ceil(wall / 2);
  const left = Math.max(rim, Math.round(margins.left * ratio));
  const bottom = Math.max(rim, Math.round(margins.bottom * ratio));
  return {
    width: maze.width,
    height: maze.height,
    pitch,
    wall,
    left,
    top: rim,
    canvasWidth: left + maze.width * pitch + rim,
    canvasHeight: rim + maze.height * pitch + bottom,
    ratio,
  };
}

/** The western side of a column; the eastern one is that of the next. */
export const columnAt = (g: Geometry, x: number) => g.left + x * g.pitch;
/** The southern side of a row; the northern one is that of the next. */
export const rowAt = (g: Geometry, y: number) => g.top + (g.height - y) * g.pitch;
/** A place in half cells: the middle of cell (0,0) is (1,1). */
export const halfX = (g: Geometry, x: number) => g.left + (x * g.pitch) / 2;
export const halfY = (g: Geometry, y: number) => g.top + g.height * g.pitch - (y * g.pitch) / 2;

/** The cell at a place of the canvas in pixels of the page (as `offsetX` and `offsetY` of a pointer), or null. */
export function cellAt(g: Geometry, x: number, y: number): Cell | null {
  const column = Math.floor((x * g.ratio - g.left) / g.pitch);
  const row = g.height - 1 - Math.floor((y * g.ratio - g.top) / g.pitch);
  return column >= 0 && row >= 0 && column < g.width && row < g.height ? [column, row] : null;
}

/**
 * The position of a wall in lists over walls: the north side of cell i at i, its east side at cells + i. -1 for the
 * southern and the western border, which have none.
 */
export function wallIndex(size: MazeSize, [x, y]: Cell, side: HeadingName): number {
  if (side === 'south') return y > 0 ? (y - 1) * size.width + x : -1;
  if (side === 'west') return x > 0 ? size.width * size.height + y * size.width + x - 1 : -1;
  return y * size.width + x + (side === 'east' ? size.width * size.height : 0);
}

/** 1 for each closed wall, in lists over walls. */
export function closedWalls(maze: MazeData): Uint8Array {
  const cells = maze.width * maze.height;
  const closed = new Uint8Array(2 * cells);
  for (let i = 0; i < cells; ++i) {
    closed[i] = maze.walls[i] & 1;
    closed[cells + i] = (maze.walls[i] >> 1) & 1;
  }
  return closed;
}
