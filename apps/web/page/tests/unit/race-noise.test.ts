import { describe, expect, it } from 'vitest';
import type { RaceGroup } from '../../src/core/types';
import { noiseCurves } from '../../src/race/noise-data';

const ended = (score: number | null, ended_by: string | null) => ({ maze: 'a', outcome: 'x', score, ended_by });
const race = (noise: unknown, mice: Record<string, ReturnType<typeof ended>[]>) =>
  ({
    world: 'failures',
    noise,
    mice: Object.entries(mice).map(([name, results]) => ({ name, results })),
  }) as unknown as RaceGroup;

describe('races under several noises', () => {
  it('make a curve for each mouse, by increasing noise', () => {
    const curves = noiseCurves([
      race(3, { two: [ended(null, 'slid'), ended(null, 'wall_error')], one: [ended(9, null), ended(null, 'slid')] }),
      race(1, { one: [ended(7, null), ended(8, null)], two: [ended(5, null), ended(null, 'slid')] }),
    ]);
    expect(curves?.noises).toEqual([1, 3]);
    expect(curves?.mice.map(({ name, finished }) => [name, finished])).toEqual([
      ['one', [100, 50]],
      ['two', [50, 0]],
    ]);
    expect(curves?.mice[1].ended.map((counts) => Object.fromEntries(counts))).toEqual([
      { slid: 1 },
      { slid: 1, wall_error: 1 },
    ]);
  });
  it('leave a gap where a mouse did not race', () =>
    expect(noiseCurves([race(0, { one: [ended(1, null)] }), race(1, {})])?.mice[0].finished).toEqual([100, null]));
  it('are none where there is one noise, or none, or one twice', () => {
    expect(noiseCurves([race(1, { one: [] })])).toBeNull();
    expect(noiseCurves([race(undefined, {}), race(undefined, {})])).toBeNull();
    expect(noiseCurves([race(1, {}), race(1, {})])).toBeNull();
  });
});
