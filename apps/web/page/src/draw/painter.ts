// The drawing on its stage: the maze, and what lies over it while one draws.
import type { Cell, MazeData } from '../core/types';
import { closedWalls, columnAt, halfX, halfY, rowAt, wallIndex, type Geometry } from '../maze/geometry';
import * as maze from '../maze/painter';
import type { Palette } from '../maze/palette';
import { isClosed, type Wall } from './model';

/** What lies over the maze; null where there is none of it. */
export interface Overlay {
  /** The wall below the pointer. */
  hover: Wall | null;
  /** The cell of the keyboard, while the canvas has the focus. */
  cursor: Cell | null;
  /** The cells of a shortest run. */
  route: Cell[] | null;
}

const turns = { north: 0, east: 1, south: 2, west: 3 };

/** The start's heading, as a tip at that side of its cell. */
function paintHeading(context: maze.Context, g: Geometry, palette: Palette, { start, heading }: MazeData) {
  context.save();
  context.translate(halfX(g, 2 * start[0] + 1), halfY(g, 2 * start[1] + 1));
  context.rotate((turns[heading] * Math.PI) / 2);
  context.beginPath();
  context.moveTo(0, -0.44 * g.pitch);
  context.lineTo(0.13 * g.pitch, -0.29 * g.pitch);
  context.lineTo(-0.13 * g.pitch, -0.29 * g.pitch);
  context.fillStyle = palette.ink;
  context.fill();
  context.restore();
}

function paintRoute(context: maze.Context, g: Geometry, palette: Palette, route: Cell[]) {
  context.strokeStyle = palette.route;
  context.lineWidth = Math.max(1.5 * g.ratio, g.pitch * 0.08);
  context.lineJoin = context.lineCap = 'round';
  context.beginPath();
  for (const [x, y] of route) context.lineTo(halfX(g, 2 * x + 1), halfY(g, 2 * y + 1));
  context.stroke();
}

/** Where the pointer would close a wall, or open one: then its middle is free, which tells without colours. */
function paintHover(context: maze.Context, g: Geometry, palette: Palette, drawing: MazeData, wall: Wall) {
  const closed = isClosed(drawing, wall);
  const index = wallIndex(drawing, [wall.x, wall.y], wall.side);
  context.fillStyle = closed ? palette.wrong : palette['to-goal'];
  maze.fillWall(context, g, index, g.wall + 2 * Math.max(1, Math.round(g.wall / 4)));
  if (!closed) return;
  const [along, across] = [Math.round(g.pitch * 0.4), g.wall];
  const back = Math.floor(across / 2);
  const inset = Math.round(g.pitch * 0.3);
  context.fillStyle = palette.paper;
  if (wall.side === 'north') context.fillRect(columnAt(g, wall.x) + inset, rowAt(g, wall.y + 1) - back, along, across);
  else context.fillRect(columnAt(g, wall.x + 1) - back, rowAt(g, wall.y + 1) + inset, across, along);
}

function paintCursor(context: maze.Context, g: Geometry, palette: Palette, [x, y]: Cell) {
  const inset = Math.round(g.pitch * 0.2);
  const side = g.pitch - 2 * inset;
  context.strokeStyle = palette['to-goal'];
  context.lineWidth = Math.max(2, Math.round(2 * g.ratio));
  context.strokeRect(columnAt(g, x) + inset, rowAt(g, y + 1) + inset, side, side);
}

export function paintDrawing(
  context: maze.Context,
  g: Geometry,
  palette: Palette,
  drawing: MazeData,
  overlay: Overlay,
) {
  maze.paintGround(context, g, palette);
  maze.paintPlates(context, g, palette, drawing);
  if (overlay.route) paintRoute(context, g, palette, overlay.route);
  maze.paintLetters(context, g, palette, drawing, overlay.route !== null);
  paintHeading(context, g, palette, drawing);
  maze.paintPosts(context, g, palette);
  maze.paintWalls(context, g, palette, closedWalls(drawing));
  maze.paintNumbers(context, g, palette);
  if (overlay.hover) paintHover(context, g, palette, drawing, overlay.hover);
  if (overlay.cursor) paintCursor(context, g, palette, overlay.cursor);
}
