// The parts of a maze on a canvas. Each paints one of them; from bottom to top in this order.
import type { Cell, MazeData } from '../core/types';
import { closedWalls, columnAt, rowAt, type Geometry } from './geometry';
import { fontOf, textOf } from './fonts';
import type { Palette } from './palette';

export type Context = CanvasRenderingContext2D;

export interface Places {
  start: Cell;
  goals: Cell[];
}

export function paintGround(context: Context, g: Geometry, palette: Palette) {
  context.fillStyle = palette.paper;
  context.fillRect(0, 0, g.canvasWidth, g.canvasHeight);
}

/** A cell's square, without `rim` device pixels on each side. The tone is that of `context.fillStyle`. */
export function fillCell(context: Context, g: Geometry, x: number, y: number, rim = 0) {
  context.fillRect(columnAt(g, x) + rim, rowAt(g, y + 1) + rim, g.pitch - 2 * rim, g.pitch - 2 * rim);
}

/** The plates of start and goals; `rim` leaves the colours below them to be seen. */
export function paintPlates(context: Context, g: Geometry, palette: Palette, { start, goals }: Places, rim = 0) {
  context.fillStyle = palette.goal;
  for (let i = 0; i < goals.length; ++i) fillCell(context, g, goals[i][0], goals[i][1], rim);
  context.fillStyle = palette.start;
  fillCell(context, g, start[0], start[1], rim);
}

/** The letters S and G: in the middle of their cells, or in the upper left corner where others are there. */
export function paintLetters(
  context: Context,
  g: Geometry,
  palette: Palette,
  { start, goals }: Places,
  corner = false,
) {
  const size = Math.round(g.pitch * (corner ? 0.28 : 0.48));
  if (size < 5 * g.ratio) return;
  context.font = fontOf(palette, size, 600);
  context.fillStyle = palette.ink;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const inset = Math.round(g.pitch * (corner ? 0.25 : 0.5));
  const down = inset + Math.round(size * 0.06);
  context.fillText('S', columnAt(g, start[0]) + inset, rowAt(g, start[1] + 1) + down);
  for (let i = 0; i < goals.length; ++i)
    if (goals[i][0] !== start[0] || goals[i][1] !== start[1])
      context.fillText('G', columnAt(g, goals[i][0]) + inset, rowAt(g, goals[i][1] + 1) + down);
}

export function paintPosts(context: Context, g: Geometry, palette: Palette) {
  if (g.pitch < 4 * g.wall) return;
  const back = Math.floor(g.wall / 2);
  context.fillStyle = palette.post;
  for (let y = 0; y <= g.height; ++y)
    for (let x = 0; x <= g.width; ++x) context.fillRect(columnAt(g, x) - back, rowAt(g, y) - back, g.wall, g.wall);
}

/** A wall by its position in lists over walls (see wallIndex), in the tone of `context.fillStyle`. */
export function fillWall(context: Context, g: Geometry, index: number, thickness = g.wall) {
  const cells = g.width * g.height;
  const north = index < cells;
  const cell = north ? index : index - cells;
  const x = cell % g.width;
  const y = (cell - x) / g.width;
  const back = Math.floor(thickness / 2);
  if (north) context.fillRect(columnAt(g, x) - back, rowAt(g, y + 1) - back, g.pitch + thickness, thickness);
  else context.fillRect(columnAt(g, x + 1) - back, rowAt(g, y + 1) - back, thickness, g.pitch + thickness);
}

/** The southern and the western border, which have no place in lists over walls. */
export function fillBorder(context: Context, g: Geometry) {
  const back = Math.floor(g.wall / 2);
  context.fillRect(columnAt(g, 0) - back, rowAt(g, 0) - back, g.width * g.pitch + g.wall, g.wall);
  context.fillRect(columnAt(g, 0) - back, rowAt(g, g.height) - back, g.wall, g.height * g.pitch + g.wall);
}

/** All closed walls and the border in ink; `closed` as closedWalls gives them. */
export function paintWalls(context: Context, g: Geometry, palette: Palette, closed: ArrayLike<number>) {
  context.fillStyle = palette.ink;
  for (let wall = 0; wall < closed.length; ++wall) if (closed[wall]) fillWall(context, g, wall);
  fillBorder(context, g);
}

/** Strips for the numbers, where a closer look leaves no room beside the maze. */
function paintStrips(context: Context, g: Geometry, palette: Palette, column: number, base: number) {
  context.fillStyle = palette.paper;
  context.globalAlpha = 0.85;
  if (rowAt(g, 0) > base - Math.round(12 * g.ratio))
    context.fillRect(0, base - Math.round(12 * g.ratio), g.canvasWidth, g.canvasHeight);
  if (g.left < column) context.fillRect(0, 0, column + Math.round(4 * g.ratio), g.canvasHeight);
  context.globalAlpha = 1;
}

/**
 * The numbers of columns and rows, outside of the maze or at the border of the picture: every second or fourth where they
 * would stand too close.
 */
export function paintNumbers(context: Context, g: Geometry, palette: Palette) {
  const size = Math.round(11 * g.ratio);
  const base = Math.min(rowAt(g, 0) + Math.round(16 * g.ratio), g.canvasHeight - Math.round(4 * g.ratio));
  const column = Math.max(g.left - Math.round(7 * g.ratio), Math.round(16 * g.ratio));
  paintStrips(context, g, palette, column, base);
  const room = g.pitch / size;
  const every = room >= 1.6 ? 1 : room >= 0.8 ? 2 : room >= 0.4 ? 4 : 8;
  context.font = fontOf(palette, size);
  context.fillStyle = palette.muted;
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  const half = g.pitch >> 1;
  for (let x = 0; x < g.width; x += every) context.fillText(textOf(x), columnAt(g, x) + half, base);
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (let y = 0; y < g.height; y += every) context.fillText(textOf(y), column, rowAt(g, y) - half);
}

/** A whole maze; `corner` where something is painted over it, which would cover its letters. */
export function paintMaze(context: Context, g: Geometry, palette: Palette, maze: MazeData, corner = false) {
  paintGround(context, g, palette);
  paintPlates(context, g, palette, maze);
  paintLetters(context, g, palette, maze, corner);
  paintPosts(context, g, palette);
  paintWalls(context, g, palette, closedWalls(maze));
  if (g.left > g.wall) paintNumbers(context, g, palette);
}
