// What a pointer draws, from where it goes down to where it is lifted.
import type { Cell, MazeData } from '../core/types';
import * as model from './model';
import { between, cellAt, nearestWall } from './nearest';

export type Tool = 'walls' | 'goals' | 'start';

/** A stroke: the maze as it is after the pointer came to a place. */
export type Stroke = (maze: MazeData, x: number, y: number) => MazeData;

const wallStroke =
  (closed: boolean, reach: number): Stroke =>
  (maze, x, y) => {
    const wall = nearestWall(maze, x, y, reach);
    return wall ? model.withWall(maze, wall, closed) : maze;
  };

const goalStroke =
  (on: boolean): Stroke =>
  (maze, x, y) => {
    const cell = cellAt(maze, x, y);
    return cell ? model.withGoal(maze, cell, on) : maze;
  };

const startStroke: Stroke = (maze, x, y) => {
  const cell = cellAt(maze, x, y);
  return cell ? model.withStart(maze, cell) : maze;
};

/** Carries one goal along; the others stay as they were where it only passes. */
function carriedGoal(before: MazeData, from: Cell): Stroke {
  return (maze, x, y) => {
    const cell = cellAt(before, x, y);
    if (!cell) return maze;
    return model.isSame(cell, from) ? before : model.withMovedGoal(before, from, cell);
  };
}

/** The stroke that begins at a place with that tool; null where there is nothing to draw. */
export function beginStroke(tool: Tool, maze: MazeData, x: number, y: number, reach: number): Stroke | null {
  const cell = cellAt(maze, x, y);
  if (!cell) return null;
  if (tool === 'goals') return goalStroke(!model.isGoal(maze, cell));
  if (tool === 'start') return startStroke;
  const wall = nearestWall(maze, x, y, reach);
  if (wall) return wallStroke(!model.isClosed(maze, wall), reach);
  if (model.isSame(maze.start, cell)) return startStroke;
  return model.isGoal(maze, cell) ? carriedGoal(maze, cell) : null;
}

/** The maze after the pointer went from one place to another; what lies between is drawn as well. */
export const drawn = (stroke: Stroke, maze: MazeData, from: [number, number], to: [number, number]) =>
  between(from, to).reduce((now, [x, y]) => stroke(now, x, y), maze);
