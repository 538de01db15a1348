import { describe, expect, it } from 'vitest';
import type { RaceGroup, RaceResults } from '../../src/core/types';
import { joined } from '../../src/results/joining';
import { sorted } from '../../src/ui/sorting';

describe('sorted', () => {
  const rows = [{ v: 3 }, { v: null }, { v: 1 }, { v: 3, second: true }];
  const value = (row: { v: number | null }) => row.v;

  it('puts numbers in order and leaves equals as they were', () => {
    expect(sorted(rows, value, 'ascending')).toEqual([{ v: 1 }, { v: 3 }, { v: 3, second: true }, { v: null }]);
  });
  it('puts what has no value last in both directions', () => {
    expect(sorted(rows, value, 'descending')).toEqual([{ v: 3 }, { v: 3, second: true }, { v: 1 }, { v: null }]);
  });
  it('reads numbers in names', () => {
    expect(sorted(['maze-10', 'maze-9'], (name) => name, 'ascending')).toEqual(['maze-9', 'maze-10']);
  });
  it('leaves its list alone', () => {
    const list = [2, 1];
    sorted(list, (entry) => entry, 'ascending');
    expect(list).toEqual([2, 1]);
  });
});

const race = (name: string, mean: number | null, stopped = false) =>
  ({
    labmouse: '1',
    seed: 1,
    stopped,
    groups: [{ world: 'steps', mazes: [{ name: 'one' }], mice: [{ name, mean_par1: mean }] }],
  }) as unknown as RaceResults;

describe('joined', () => {
  it('ranks by how many contests have a score first, where a contest without one has no place in means', () => {
    const piece = (name: string, finished: number, mean_score: number | null, failure_score: number | null) => ({
      ...race(name, null),
      groups: [{ world: 'elsewhere', failure_score, mazes: [], mice: [{ name, finished, mean_score }] }],
    });
    const order = (failure: number | null) => {
      const mice: [string, number, number | null][] = [
        ['lucky', 1, 3],
        ['none', 0, null],
        ['slow', 4, 9],
        ['fast', 4, 5],
      ];
      const pieces = mice.map(
        ([name, finished, mean]) => piece(name, finished, mean, failure) as unknown as RaceResults,
      );
      return joined(pieces, false)!.groups[0].mice.map(({ name }) => name);
    };
    expect(order(null)).toEqual(['fast', 'slow', 'lucky', 'none']);
    expect(order(2000)).toEqual(['lucky', 'fast', 'slow', 'none']);
  });
  it('brings the best mouse first, and those without a mean last', () => {
    const all = joined([race('poor', 50), race('none', null), race('good', 20)], false)!;
    expect(all.groups[0].mice.map(({ name }) => name)).toEqual(['good', 'poor', 'none']);
    expect(all.groups[0].mazes).toEqual([{ name: 'one' }]);
    expect(all.stopped).toBe(false);
  });
  it('was stopped when a piece was, or when pieces are missing', () => {
    expect(joined([race('a', 1)], true)!.stopped).toBe(true);
    expect(joined([race('a', 1), race('b', 2, true)], false)!.stopped).toBe(true);
  });
  it('joins the mice of other worlds, too', () => {
    const piece = (name: string, mean: number | null) => {
      const group = { world: 'seconds', mazes: [], mice: [{ name, mean_score: mean }] } as unknown as RaceGroup;
      return { ...race(name, null), groups: [group] };
    };
    const all = joined([piece('slow', 9), piece('none', null), piece('fast', 5)], false)!;
    expect(all.groups[0].mice.map(({ name }) => name)).toEqual(['fast', 'slow', 'none']);
  });
  it('is no race without pieces', () => expect(joined([], true)).toBeNull());
});
