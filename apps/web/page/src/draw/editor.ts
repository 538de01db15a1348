// The drawing with its history: whole steps, and a stroke that is not finished yet.
import type { MazeData } from '../core/types';
import { createHistory } from './history';

export type Editor = ReturnType<typeof createEditor>;

/** `changed` hears of every change, a sketch included. */
export function createEditor(first: MazeData, changed: () => void) {
  const history = createHistory(first);
  let stroke: MazeData | null = null;
  function settle() {
    if (stroke) history.add(stroke);
    stroke = null;
    changed();
  }
  return {
    /** The drawing, with the stroke that is being made. */
    maze: () => stroke ?? history.now(),
    /** A step, or nothing where the maze is the same one. */
    change(maze: MazeData) {
      stroke = maze === history.now() ? null : maze;
      settle();
    },
    /** What a stroke has made so far; `settle` makes it one step, `undo` takes it back. */
    sketch(maze: MazeData) {
      stroke = maze;
      changed();
    },
    settle,
    undo() {
      if (stroke) stroke = null;
      else history.undo();
      changed();
    },
    redo() {
      if (!stroke) history.redo();
      changed();
    },
    canUndo: () => stroke !== null || history.canUndo(),
    canRedo: () => stroke === null && history.canRedo(),
  };
}
