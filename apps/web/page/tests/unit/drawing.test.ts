import { describe, expect, it } from 'vitest';
import type { Cell, HeadingName, MazeData } from '../../src/core/types';
import * as model from '../../src/draw/model';

const sides: HeadingName[] = ['north', 'east', 'south', 'west'];

/** An open maze with its border closed. */
function open(width: number, height: number): MazeData {
  const walls = Array.from({ length: width * height }, (_, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    return (y === height - 1 ? 1 : 0) | (x === width - 1 ? 2 : 0) | (y === 0 ? 4 : 0) | (x === 0 ? 8 : 0);
  });
  return { name: 'test', width, height, walls, start: [0, 0], heading: 'north', goals: [[1, 1]] };
}

const closed = (maze: MazeData, cell: Cell, side: HeadingName) =>
  (maze.walls[cell[1] * maze.width + cell[0]] & (1 << sides.indexOf(side))) !== 0;

/** Each wall is the same from both sides, and the border is closed. */
function expectSound(maze: MazeData) {
  expect(maze.walls).toHaveLength(maze.width * maze.height);
  for (let y = 0; y < maze.height; ++y)
    for (let x = 0; x < maze.width; ++x)
      for (const side of sides) {
        const other = model.neighbour([x, y], side);
        const here = closed(maze, [x, y], side);
        const there = model.isInside(maze, other) ? closed(maze, other, sides[(sides.indexOf(side) + 2) % 4]) : true;
        expect(here, `${side} of ${x},${y}`).toBe(there);
      }
}

/** Some walls that no symmetry takes to themselves. */
function uneven(): MazeData {
  let maze = open(4, 3);
  for (const [x, y, side] of [
    [0, 0, 'east'],
    [1, 1, 'north'],
    [2, 0, 'north'],
    [2, 2, 'east'],
  ] as const)
    maze = model.withWall(maze, { x, y, side }, true);
  return model.withGoal({ ...maze, heading: 'east' }, [3, 2], true);
}

describe('walls', () => {
  it('are closed and opened on both sides', () => {
    const maze = model.withWall(open(3, 2), { x: 1, y: 0, side: 'east' }, true);
    expect(closed(maze, [1, 0], 'east')).toBe(true);
    expect(closed(maze, [2, 0], 'west')).toBe(true);
    expectSound(maze);
    const above = model.withWall(maze, { x: 0, y: 0, side: 'north' }, true);
    expect(closed(above, [0, 1], 'south')).toBe(true);
    expectSound(above);
    expect(model.withWall(maze, { x: 1, y: 0, side: 'east' }, false).walls).toEqual(open(3, 2).walls);
  });

  it('leave the maze that was given alone, and are the same maze where nothing changes', () => {
    const maze = open(3, 2);
    const before = JSON.stringify(maze);
    model.withWall(maze, { x: 0, y: 0, side: 'north' }, true);
    expect(JSON.stringify(maze)).toBe(before);
    expect(model.withWall(maze, { x: 0, y: 0, side: 'north' }, false)).toBe(maze);
  });

  it('of the border stay closed', () => {
    const maze = open(3, 2);
    expect(model.withWall(maze, { x: 2, y: 0, side: 'east' }, false)).toBe(maze);
    expect(model.withWall(maze, { x: 0, y: 1, side: 'north' }, false)).toBe(maze);
    expect(model.withWall(maze, { x: -1, y: 0, side: 'east' }, false)).toBe(maze);
    expect(model.wallOf(maze, [0, 0], 'west')).toBeNull();
    expect(model.wallOf(maze, [0, 0], 'south')).toBeNull();
    expect(model.wallOf(maze, [2, 1], 'north')).toBeNull();
  });

  it('have one name from both sides', () => {
    const maze = open(3, 2);
    expect(model.wallOf(maze, [2, 1], 'west')).toEqual({ x: 1, y: 1, side: 'east' });
    expect(model.wallOf(maze, [1, 1], 'east')).toEqual({ x: 1, y: 1, side: 'east' });
    expect(model.wallOf(maze, [1, 1], 'south')).toEqual({ x: 1, y: 0, side: 'north' });
  });

  it('can all be closed', () => {
    expectSound(model.withAllClosed(open(3, 2)));
  });
});

describe('start and goals', () => {
  it('stay inside', () => {
    const maze = open(3, 2);
    expect(model.withStart(maze, [2, 1]).start).toEqual([2, 1]);
    expect(model.withStart(maze, [3, 1])).toBe(maze);
    expect(model.withGoal(maze, [0, -1], true)).toBe(maze);
    expect(model.withMovedGoal(maze, [1, 1], [1, 2])).toBe(maze);
  });

  it('turn the start clockwise', () => {
    const turns: string[] = [];
    for (let maze = open(2, 2), i = 0; i < 4; ++i) turns.push((maze = model.withTurnedStart(maze)).heading);
    expect(turns).toEqual(['east', 'south', 'west', 'north']);
  });

  it('keep one goal at least, and each but once', () => {
    const maze = open(3, 2);
    expect(model.withGoal(maze, [1, 1], false)).toBe(maze);
    expect(model.withGoal(maze, [1, 1], true)).toBe(maze);
    const two = model.withGoal(maze, [0, 0], true);
    expect(two.goals).toEqual([
      [0, 0],
      [1, 1],
    ]);
    expect(model.withGoal(two, [1, 1], false).goals).toEqual([[0, 0]]);
    expect(model.withMovedGoal(two, [0, 0], [1, 1]).goals).toEqual([[1, 1]]);
    expect(model.withMovedGoal(two, [0, 0], [2, 0]).goals).toEqual([
      [2, 0],
      [1, 1],
    ]);
  });
});

describe('mirror and turn', () => {
  it('carry walls, start, heading and goals together', () => {
    const turned = model.rotated(uneven());
    expect([turned.width, turned.height]).toEqual([3, 4]);
    expectSound(turned);
    expect(turned.start).toEqual([0, 3]);
    expect(turned.heading).toBe('south');
    expect(turned.goals).toEqual([
      [2, 0],
      [1, 2],
    ]);
    expect(closed(turned, [0, 3], 'south')).toBe(true);
    const mirror = model.mirrored(uneven());
    expectSound(mirror);
    expect(mirror.start).toEqual([3, 0]);
    expect(mirror.heading).toBe('west');
    expect(closed(mirror, [3, 0], 'west')).toBe(true);
    expect(closed(mirror, [2, 1], 'north')).toBe(true);
  });

  it('come back after two mirrors and after four turns', () => {
    expect(model.mirrored(model.mirrored(uneven()))).toEqual(uneven());
    let maze = uneven();
    for (let i = 0; i < 4; ++i) maze = model.rotated(maze);
    expect(maze).toEqual(uneven());
  });
});
