import { expect, it } from 'vitest';
import type { MazeData } from '../../src/core/types';
import { createEditor } from '../../src/draw/editor';
import { cellInWords, press, type Key } from '../../src/draw/keys';
import { beginStroke, drawn, type Tool } from '../../src/draw/strokes';

/** Three by three open cells. */
const maze: MazeData = {
  name: 'test',
  width: 3,
  height: 3,
  walls: [12, 4, 6, 8, 0, 2, 9, 1, 3],
  start: [0, 0],
  heading: 'north',
  goals: [[2, 2]],
};

function draw(tool: Tool, from: [number, number], to: [number, number], on = maze): MazeData {
  const stroke = beginStroke(tool, on, ...from, 0.3);
  return stroke ? drawn(stroke, stroke(on, ...from), from, to) : on;
}

it('draws the walls along a line, all closed or all open as the first', () => {
  const closed = draw('walls', [0.5, 1], [2.5, 1.05]);
  expect(closed.walls).toEqual([13, 5, 7, 12, 4, 6, 9, 1, 3]);
  expect(draw('walls', [0.5, 1], [2.5, 1.05], closed)).toEqual(maze);
});

it('carries start and goals from the middle of their cells', () => {
  expect(draw('walls', [0.5, 0.5], [1.5, 1.5]).start).toEqual([1, 1]);
  expect(draw('walls', [2.5, 2.5], [1.5, 0.5]).goals).toEqual([[1, 0]]);
  expect(draw('walls', [1.5, 1.5], [2.5, 1.5])).toBe(maze);
});

it('leaves alone the goals that another one is carried over', () => {
  const two: MazeData = {
    ...maze,
    goals: [
      [1, 2],
      [2, 2],
    ],
  };
  expect(draw('walls', [2.5, 2.5], [0.5, 2.5], two).goals).toEqual([
    [0, 2],
    [1, 2],
  ]);
  expect(draw('walls', [2.5, 2.5], [1.5, 2.5], two).goals).toEqual([[1, 2]]);
});

it('paints goals as the first cell becomes', () => {
  const three = draw('goals', [0.5, 2.5], [2.5, 2.5]);
  expect(three.goals).toEqual([
    [0, 2],
    [1, 2],
    [2, 2],
  ]);
  expect(draw('goals', [0.5, 2.5], [2.5, 2.5], three).goals).toEqual([[2, 2]]);
});

it('is one step to undo, however long', () => {
  const editor = createEditor(maze, () => undefined);
  editor.sketch({ ...maze, name: 'a' });
  editor.sketch({ ...maze, name: 'b' });
  editor.settle();
  expect([editor.maze().name, editor.canUndo()]).toEqual(['b', true]);
  editor.undo();
  expect([editor.maze(), editor.canUndo(), editor.canRedo()]).toEqual([maze, false, true]);
  editor.sketch({ ...maze, name: 'c' });
  editor.undo();
  expect([editor.maze(), editor.canRedo()]).toEqual([maze, true]);
});

const key = (name: string, shiftKey = false): Key => ({
  key: name,
  shiftKey,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
});

it('draws by keys and says what came of it', () => {
  expect(press(key('ArrowUp'), maze, [0, 0])).toEqual({ maze, cursor: [0, 1], said: '(0,1): walls west' });
  expect(press(key('ArrowLeft'), maze, [0, 0])?.cursor).toEqual([0, 0]);
  const closed = press(key('d'), maze, [0, 0])!;
  expect([closed.said, closed.maze.walls[0], closed.maze.walls[1]]).toEqual(['east of (0,0) closed', 14, 12]);
  expect(press(key('ArrowLeft', true), closed.maze, [1, 0])?.maze.walls).toEqual(maze.walls);
  expect(press(key('a'), maze, [0, 0])).toMatchObject({
    maze,
    said: 'west of (0,0) is the border, which stays closed',
  });
  expect(press(key('g'), maze, [2, 2])).toMatchObject({ maze, said: 'a maze must have at least one goal' });
  expect(press(key('g'), maze, [1, 1])?.maze.goals).toEqual([
    [1, 1],
    [2, 2],
  ]);
  expect(press(key('H'), maze, [1, 1])?.maze.start).toEqual([1, 1]);
  expect(press(key('r'), maze, [1, 1])?.maze.heading).toBe('east');
});

it('leaves other keys to the browser', () => {
  expect(press(key('Tab'), maze, [0, 0])).toBeNull();
  expect(press({ ...key('r'), ctrlKey: true }, maze, [0, 0])).toBeNull();
});

it('puts a cell into words', () => {
  expect(cellInWords(maze, [0, 0])).toBe('(0,0): walls south, west; start, heading north');
  expect(cellInWords(maze, [1, 1])).toBe('(1,1): no walls');
  expect(cellInWords(maze, [2, 2])).toBe('(2,2): walls north, east; goal');
});
