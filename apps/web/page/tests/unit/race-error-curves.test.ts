import { describe, expect, it } from 'vitest';
import type { RaceGroup } from '../../src/core/types';
import { errorCurves } from '../../src/race/error-curves';

const ended = (score: number | null, ended_by: string | null) => ({ maze: 'a', outcome: 'x', score, ended_by });
const race = (variation: unknown, mice: Record<string, ReturnType<typeof ended>[]>, noise: unknown = 1) =>
  ({
    world: 'failures',
    noise,
    variation,
    mice: Object.entries(mice).map(([name, results]) => ({ name, results })),
  }) as unknown as RaceGroup;

describe('races under several variations', () => {
  it('make a curve for each mouse, by increasing variation', () => {
    const curves = errorCurves([
      race(3, { two: [ended(null, 'slid'), ended(null, 'wall_error')], one: [ended(9, null), ended(null, 'slid')] }),
      race(1, { one: [ended(7, null), ended(8, null)], two: [ended(5, null), ended(null, 'slid')] }),
    ]);
    expect(curves?.scaled).toBe('variation');
    expect(curves?.scales).toEqual([1, 3]);
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
    expect(errorCurves([race(0, { one: [ended(1, null)] }), race(1, {})])?.mice[0].finished).toEqual([100, null]));
  it('are none where there is one variation, or none, or one twice', () => {
    expect(errorCurves([race(1, { one: [] })])).toBeNull();
    expect(errorCurves([race(undefined, {}), race(undefined, {})])).toBeNull();
    expect(errorCurves([race(1, {}), race(1, {})])).toBeNull();
  });
  it('may differ in their noise instead, but not in both', () => {
    const noisy = (variation: number, noise: number) => race(variation, { one: [ended(1, null)] }, noise);
    expect(errorCurves([noisy(1, 2), noisy(1, 1)])).toMatchObject({ scaled: 'noise', scales: [1, 2] });
    expect(errorCurves([noisy(1, 2), noisy(2, 1)])).toBeNull();
  });
});
