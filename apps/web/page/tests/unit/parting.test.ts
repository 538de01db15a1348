import { describe, expect, it } from 'vitest';
import { partingOf } from '../../src/player/parting';

/** A walk from cell to cell: places in half cells, all heading north. */
const walk = (...cells: [number, number][]) => ({
  x: cells.map(([x]) => 2 * x + 1),
  y: cells.map(([, y]) => 2 * y + 1),
  heading: cells.map(() => 0),
  action: cells.slice(1).map(([x, y]) => `to ${x},${y}`),
});

describe('two walks', () => {
  it('part before the first step that leads elsewhere', () => {
    const parting = partingOf(walk([0, 0], [0, 1], [0, 2], [0, 3]), walk([0, 0], [0, 1], [1, 1], [1, 2]));
    expect(parting).toEqual({ frame: 1, cell: [0, 1], actions: ['to 0,2', 'to 1,1'] });
  });
  it('part where one of them ends', () => {
    const parting = partingOf(walk([0, 0], [0, 1]), walk([0, 0], [0, 1], [0, 2]));
    expect(parting).toEqual({ frame: 1, cell: [0, 1], actions: [null, 'to 0,2'] });
    const other = partingOf(walk([0, 0], [0, 1], [0, 2]), walk([0, 0], [0, 1]));
    expect(other).toEqual({ frame: 1, cell: [0, 1], actions: ['to 0,2', null] });
  });
  it('do not part where they are the same, whatever the steps are called', () => {
    const one = walk([0, 0], [0, 1]);
    expect(partingOf(one, { ...walk([0, 0], [0, 1]), action: ['ahead'], heading: [8, 8] })).toBeNull();
    expect(partingOf(one, { ...walk([0, 0], [0, 1]), heading: [0, 2] })?.frame).toBe(0);
  });
});
