import { expect, it } from 'vitest';
import { between, cellAt, nearestWall } from '../../src/draw/nearest';

const size = { width: 4, height: 3 };

it('finds the wall beside a place', () => {
  expect(nearestWall(size, 1.1, 0.5)).toEqual({ x: 0, y: 0, side: 'east' });
  expect(nearestWall(size, 0.9, 0.5)).toEqual({ x: 0, y: 0, side: 'east' });
  expect(nearestWall(size, 2.5, 1.9)).toEqual({ x: 2, y: 1, side: 'north' });
  expect(nearestWall(size, 2.5, 2.1)).toEqual({ x: 2, y: 1, side: 'north' });
});

it('takes the nearer one of two', () => {
  expect(nearestWall(size, 1.25, 1.22)).toEqual({ x: 1, y: 0, side: 'north' });
  expect(nearestWall(size, 1.22, 1.25)).toEqual({ x: 0, y: 1, side: 'east' });
});

it('finds none in the middle of a cell, beside the border and outside', () => {
  expect(nearestWall(size, 1.5, 1.5)).toBeNull();
  expect(nearestWall(size, 0.05, 0.5)).toBeNull();
  expect(nearestWall(size, 3.95, 0.5)).toBeNull();
  expect(nearestWall(size, 1.5, 2.95)).toBeNull();
  expect(nearestWall(size, -0.1, 0.5)).toBeNull();
  expect(nearestWall(size, 4.1, 1.05)).toBeNull();
});

it('finds none at a post, so that a line along walls draws no others', () => {
  expect(nearestWall(size, 2.02, 1.05)).toBeNull();
  const sides = new Set(between([0.5, 1.04], [3.5, 0.96]).map(([x, y]) => nearestWall(size, x, y)?.side));
  expect(sides).toEqual(new Set(['north', undefined]));
});

it('misses no wall between two places', () => {
  const found = new Set(between([0.5, 1], [3.5, 1]).map(([x, y]) => nearestWall(size, x, y)?.x));
  expect(found).toEqual(new Set([0, 1, 2, 3, undefined]));
  expect(between([1, 1], [1, 1])).toEqual([[1, 1]]);
});

it('knows the cell of a place', () => {
  expect(cellAt(size, 3.9, 2.9)).toEqual([3, 2]);
  expect(cellAt(size, 4, 2)).toBeNull();
  expect(cellAt(size, -0.1, 2)).toBeNull();
});
