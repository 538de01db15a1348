import { describe, expect, it } from 'vitest';
import {
  bare,
  cellAt,
  closedWalls,
  columnAt,
  fit,
  halfX,
  halfY,
  numbered,
  rowAt,
  wallIndex,
} from '../../src/maze/geometry';
import { maze } from './plays';

describe('a maze on a canvas', () => {
  it.each([1, 1.25, 1.5, 2, 3])('has a whole number of device pixels to a cell, and fits (ratio %s)', (ratio) => {
    for (const width of [200, 333, 1001]) {
      const g = fit({ width: 16, height: 16 }, width, 700, ratio, numbered);
      expect(
        Number.isInteger(g.pitch) && Number.isInteger(g.wall) && Number.isInteger(g.left) && Number.isInteger(g.top),
      ).toBe(true);
      expect(g.canvasWidth).toBeLessThanOrEqual(width * ratio);
      expect(g.canvasHeight).toBeLessThanOrEqual(700 * ratio);
      expect(g.canvasWidth + 16 * 1).toBeGreaterThan(Math.min(width, 700) * ratio - 16 - 4 * ratio);
    }
  });

  it('has its south-western cell below on the left', () => {
    const g = fit(maze, 300, 300, 1, bare);
    expect(rowAt(g, 0)).toBe(g.top + 2 * g.pitch);
    expect([halfX(g, 1), halfY(g, 1)]).toEqual([columnAt(g, 0) + g.pitch / 2, rowAt(g, 0) - g.pitch / 2]);
  });

  it('finds cells and their nearest walls under a pointer', () => {
    const g = fit(maze, 300, 300, 2, bare);
    const at = (x: number, y: number): [number, number] => [
      (g.left + x * g.pitch) / 2,
      (g.top + (2 - y) * g.pitch) / 2,
    ];
    expect(cellAt(g, ...at(0.5, 0.5))).toEqual([0, 0]);
    expect(cellAt(g, ...at(2.5, 1.5))).toEqual([2, 1]);
    expect(cellAt(g, ...at(3.2, 0.5))).toBeNull();
    expect(cellAt(g, ...at(-0.1, 0.5))).toBeNull();
  });
});

describe('walls', () => {
  it('have one place each, whichever cell they are named by', () => {
    expect(wallIndex(maze, [1, 0], 'north')).toBe(wallIndex(maze, [1, 1], 'south'));
    expect(wallIndex(maze, [0, 0], 'east')).toBe(wallIndex(maze, [1, 0], 'west'));
    expect([wallIndex(maze, [1, 0], 'south'), wallIndex(maze, [0, 1], 'west')]).toEqual([-1, -1]);
    expect(wallIndex(maze, [2, 1], 'east')).toBe(11);
  });

  it('are closed as the cells say', () => {
    const closed = closedWalls(maze);
    expect(closed[wallIndex(maze, [1, 0], 'north')]).toBe(1);
    expect(closed[wallIndex(maze, [0, 0], 'north')]).toBe(0);
    expect(closed[wallIndex(maze, [0, 0], 'east')]).toBe(1);
  });
});
