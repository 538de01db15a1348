// Drawing by keyboard: what a key does to the maze at the cursor, and what is said about it.
import type { Cell, HeadingName, MazeData } from '../core/types';
import * as model from './model';

const arrows: Record<string, HeadingName> = {
  ArrowUp: 'north',
  ArrowRight: 'east',
  ArrowDown: 'south',
  ArrowLeft: 'west',
};
const letters: Record<string, HeadingName> = { w: 'north', d: 'east', s: 'south', a: 'west' };

export interface Key {
  key: string;
  shiftKey: boolean;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}

export interface Pressed {
  maze: MazeData;
  cursor: Cell;
  said: string;
}

const named = ([x, y]: Cell) => `(${x},${y})`;

/** A cell in words: where it is, its walls, and what it is. */
export function cellInWords(maze: MazeData, cell: Cell): string {
  const sides = model.headings.filter((_, i) => maze.walls[cell[1] * maze.width + cell[0]] & (1 << i));
  const walls = sides.length === 0 ? 'no walls' : sides.length === 4 ? 'all walls' : `walls ${sides.join(', ')}`;
  const start = model.isSame(maze.start, cell) ? `; start, heading ${maze.heading}` : '';
  return `${named(cell)}: ${walls}${start}${model.isGoal(maze, cell) ? '; goal' : ''}`;
}

function toggled(maze: MazeData, cursor: Cell, side: HeadingName): Pressed {
  const wall = model.wallOf(maze, cursor, side);
  if (!wall) return { maze, cursor, said: `${side} of ${named(cursor)} is the border, which stays closed` };
  const closed = !model.isClosed(maze, wall);
  const said = `${side} of ${named(cursor)} ${closed ? 'closed' : 'open'}`;
  return { maze: model.withWall(maze, wall, closed), cursor, said };
}

function moved(maze: MazeData, cursor: Cell, side: HeadingName): Pressed {
  const next = model.neighbour(cursor, side);
  const at = model.isInside(maze, next) ? next : cursor;
  return { maze, cursor: at, said: at === cursor ? `border; ${cellInWords(maze, at)}` : cellInWords(maze, at) };
}

function goal(maze: MazeData, cursor: Cell): Pressed {
  const on = !model.isGoal(maze, cursor);
  const next = model.withGoal(maze, cursor, on);
  const done = on ? `${named(cursor)} is a goal` : `${named(cursor)} is no longer a goal`;
  return { maze: next, cursor, said: next === maze ? 'a maze must have at least one goal' : done };
}

/** What a key does; null where it does nothing here. */
export function press(key: Key, maze: MazeData, cursor: Cell): Pressed | null {
  if (key.ctrlKey || key.metaKey || key.altKey) return null;
  const letter = key.key.toLowerCase();
  if (arrows[key.key]) return (key.shiftKey ? toggled : moved)(maze, cursor, arrows[key.key]);
  if (letters[letter]) return toggled(maze, cursor, letters[letter]);
  if (letter === 'g') return goal(maze, cursor);
  if (letter === 'h') return { maze: model.withStart(maze, cursor), cursor, said: `the start is ${named(cursor)}` };
  if (letter !== 'r') return null;
  const turned = model.withTurnedStart(maze);
  return { maze: turned, cursor, said: `the start heads ${turned.heading}` };
}
