// A maze whose cells are the darker the more is lost in them.
import { closedWalls, type Geometry } from '../maze/geometry';
import {
  fillCell,
  paintGround,
  paintLetters,
  paintNumbers,
  paintPlates,
  paintPosts,
  paintWalls,
  type Context,
} from '../maze/painter';
import type { MazeData } from '../core/types';
import type { Palette } from '../maze/palette';

/** As many as the palette has tones. */
export const levels = 6;

/** The most that a cell of that level loses. Levels grow towards the most, for a few cells lose far more than all others. */
export const levelEnd = (level: number, most: number): number => most * (level / levels) ** 2;

/** 0 where nothing is lost, else 1 to `levels`. */
export function lossLevel(loss: number, most: number): number {
  if (loss <= 0) return 0;
  let level = 1;
  while (level < levels && loss > levelEnd(level, most)) ++level;
  return level;
}

export function paintLosses(context: Context, g: Geometry, palette: Palette, maze: MazeData, losses: number[]) {
  const most = Math.max(...losses);
  paintGround(context, g, palette);
  losses.forEach((loss, cell) => {
    const level = lossLevel(loss, most);
    if (level === 0) return;
    context.fillStyle = palette.heat[level - 1];
    fillCell(context, g, cell % g.width, Math.floor(cell / g.width));
  });
  paintPlates(context, g, palette, maze, Math.max(1, Math.round(g.pitch * 0.2)));
  paintLetters(context, g, palette, maze, true);
  paintPosts(context, g, palette);
  paintWalls(context, g, palette, closedWalls(maze));
  paintNumbers(context, g, palette);
}
