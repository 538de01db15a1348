// The best route of a maze on a stage, over the one of the robot that it began from.
import type { DrivePath, MazeData } from '../core/types';
import { fit, halfX, halfY, numbered, type Geometry } from '../maze/geometry';
import { paintMaze, type Context } from '../maze/painter';
import { readPalette, type Palette } from '../maze/palette';
import { createStage } from '../maze/stage';

/** Of the longer side of a saved picture, at most. */
const pixels = 1600;

function trace(context: Context, g: Geometry, { x, y }: DrivePath) {
  context.beginPath();
  for (let i = 0; i < x.length; ++i) {
    if (i === 0) context.moveTo(halfX(g, 2 * x[i]), halfY(g, 2 * y[i]));
    else context.lineTo(halfX(g, 2 * x[i]), halfY(g, 2 * y[i]));
  }
  context.stroke();
}

export function createRouteStage() {
  let maze: MazeData | null = null;
  let path: DrivePath | null = null;
  let before: DrivePath | null = null;
  function paint(context: Context, g: Geometry, palette: Palette) {
    if (!maze) return;
    paintMaze(context, g, palette, maze, path !== null);
    context.lineCap = context.lineJoin = 'round';
    if (before) {
      context.lineWidth = Math.max(1, g.pitch * 0.06);
      context.strokeStyle = palette.ink;
      context.setLineDash([g.pitch * 0.15, g.pitch * 0.2]);
      trace(context, g, before);
      context.setLineDash([]);
    }
    if (!path) return;
    context.lineWidth = Math.max(1, g.pitch * 0.13);
    context.strokeStyle = palette['to-goal'];
    trace(context, g, path);
  }
  const stage = createStage({ width: 16, height: 16 }, paint, { numbers: true });
  return {
    stage,
    show(now: MazeData, newPath: DrivePath | null, oldPath: DrivePath | null, words: string) {
      const other = !maze || maze.width !== now.width || maze.height !== now.height;
      maze = now;
      path = newPath;
      before = oldPath;
      stage.describe(words);
      if (other) stage.resize(now);
      else stage.redraw();
    },
    /** The same for a file: its size, and what paints it. */
    picture() {
      const [g, palette] = [fit(maze ?? { width: 1, height: 1 }, pixels, pixels, 1, numbered), readPalette()];
      return { g, paint: (context: Context) => paint(context, g, palette) };
    },
  };
}
