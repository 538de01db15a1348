// A closer look at a maze: what stays where, and what is never beyond the border.
import { describe, expect, it } from 'vitest';
import { cameraOf, closest, seenThrough, wholeMaze, zoomed } from '../../src/maze/camera';
import { columnAt, fit, numbered, rowAt } from '../../src/maze/geometry';

const maze = { width: 16, height: 16 };
const fitted = fit(maze, 400, 400, 1, numbered);
const room = { width: 400, height: 400 };

describe('a closer look', () => {
  it('keeps the place under the pointer where it is', () => {
    const before = seenThrough({ scale: 2, x: 8, y: 8 }, fitted, room, numbered);
    const place: [number, number] = [7, 9];
    const after = seenThrough(zoomed({ scale: 2, x: 8, y: 8 }, 1.5, 10, place), fitted, room, numbered);
    expect(after.pitch).toBeGreaterThan(before.pitch);
    expect(Math.abs(columnAt(after, place[0]) - columnAt(before, place[0]))).toBeLessThanOrEqual(2);
    expect(Math.abs(rowAt(after, place[1]) - rowAt(before, place[1]))).toBeLessThanOrEqual(2);
  });
  it('shows no ground beyond the maze that the maze could fill', () => {
    for (const [x, y] of [
      [-50, -50],
      [66, 66],
    ]) {
      const g = seenThrough({ scale: 3, x, y }, fitted, room, numbered);
      expect(columnAt(g, 0)).toBeLessThanOrEqual(numbered.left);
      expect(columnAt(g, 16)).toBeGreaterThanOrEqual(room.width - g.wall);
      expect(rowAt(g, 16)).toBeLessThanOrEqual(g.wall);
      expect(rowAt(g, 0)).toBeGreaterThanOrEqual(room.height - numbered.bottom - g.wall);
      const camera = cameraOf(3, g);
      expect(seenThrough(camera, fitted, room, numbered)).toEqual(g);
    }
  });
  it('goes no farther than the whole maze, and so close that the smallest signs can be read', () => {
    expect(zoomed(wholeMaze(maze), 0.5, 4, [8, 8]).scale).toBe(1);
    const large = fit({ width: 64, height: 64 }, 760, 760, 1, numbered);
    expect(large.pitch * closest(large)).toBeGreaterThanOrEqual(48);
    expect(zoomed(wholeMaze(maze), 100, closest(large), [8, 8]).scale).toBe(closest(large));
  });
});
