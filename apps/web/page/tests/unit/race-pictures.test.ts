import { describe, expect, it } from 'vitest';
import type { RaceResults } from '../../src/core/types';
import { tickDigits, ticks } from '../../src/race/axis';
import { boardsOf } from '../../src/results/contests';
import { grid, ratiosOf, shares } from '../../src/race/curves-data';
import { failureDifferences, pairsOf } from '../../src/race/duel-data';
import { duelWords, failureWords } from '../../src/race/duel-words';
import { number, scoreText, signed } from '../../src/ui/format';

describe('numbers', () => {
  it('have a true minus, and a dash where there is none', () => {
    expect([number(-1.5, 2), number(null, 2), number('5', 2), number(NaN, 1)]).toEqual(['−1.50', '–', '–', '–']);
    expect([signed(1, 1), signed(0, 1), signed(-1, 1)]).toEqual(['+1.0', '0.0', '−1.0']);
    expect([scoreText(20), scoreText(20.5)]).toEqual(['20', '20.500']);
  });
});

describe('ticks', () => {
  it('are round and cover the range', () => {
    expect(ticks(35.7, 110.8, 4)).toEqual([20, 40, 60, 80, 100, 120]);
    expect(ticks(-3, 3, 6)).toEqual([-3, -2, -1, 0, 1, 2, 3]);
    expect(tickDigits(ticks(1, 1.3, 4))).toBe(1);
    expect(tickDigits(ticks(0, 500, 4))).toBe(0);
  });
  it('cover a range of nothing', () => expect(ticks(5, 5, 4).length).toBeGreaterThan(1));
});

const contest = (maze: string, score: number | null) => ({ maze, seed: 1, outcome: 'x', score });
const group = {
  world: 'steps',
  mazes: [
    { name: 'a', width: 8, height: 8, optimum: 9, bound: 10 },
    { name: 'b', width: 8, height: 8, optimum: 9, bound: 10 },
    { name: 'closed', width: 8, height: 8, optimum: null, bound: null },
  ],
  mice: [
    { name: 'one', results: [contest('a', 10), contest('b', null), contest('closed', null)] },
    { name: 'two', results: [contest('a', 15), contest('a', null), contest('b', 20)] },
  ],
};
const [board] = boardsOf({ groups: [group] } as unknown as RaceResults);

describe('distributions', () => {
  it('count the contests within a ratio, of all in mazes with a route', () => {
    const one = ratiosOf(board, 0);
    expect(one).toEqual({ ratios: [1], contests: 2 });
    expect(shares(one, [1, 2])).toEqual([50, 50]);
    expect(shares(ratiosOf(board, 1), [1, 1.5, 2])).toEqual([0, (100 / 3) * 1, 200 / 3]);
    expect(shares({ ratios: [], contests: 0 }, [1])).toEqual([null]);
  });
  it('are drawn over an ascending grid from 1 on', () => {
    for (const log of [true, false]) {
      const xs = grid(3, log);
      expect(xs[0]).toBe(1);
      expect(xs.at(-1)).toBeGreaterThanOrEqual(3);
      expect(xs.every((x, i) => i === 0 || x > xs[i - 1])).toBe(true);
    }
    expect(grid(1e9, true).at(-1)).toBe(100);
  });
});

describe('two mice', () => {
  it('are paired in mazes with a route, failed contests counted', () => {
    expect(pairsOf(board, 0, 1, 100)).toEqual([
      { maze: 0, a: 10, b: 57.5, difference: -47.5 },
      { maze: 1, a: 100, b: 20, difference: 80 },
    ]);
  });
  it('are told apart in words', () => {
    const found = {
      count: 260,
      mean: -2.5,
      interval: [-3, -2] as [number, number],
      below: 180,
      equal: 40,
      above: 40,
      sign_test: 1e-9,
      p: 1e-4,
      verdict: 'better',
    };
    expect(duelWords('a', 'b', found, 'steps')).toBe(
      'a against b: −2.500 steps on average (95 % interval −3.000 to −2.000) over 260 mazes: better. Lower in 180, equal in 40, higher in 40; sign test p < 0.0001.',
    );
    const few = duelWords('a', 'b', { ...found, count: 1, verdict: 'too few mazes' }, 'steps');
    expect(few).toContain('over 1 maze: no verdict');
    expect(few).toContain('add 7');
    const rates = failureWords({ ...found, mean: -0.1, interval: [-0.2, -0.05] }, 300, 's');
    for (const part of ['300 s', '+10.0 of 100', '+5.0 to +20.0', 'better']) expect(rates).toContain(part);
  });
  it('differ in their shares of failed contests', () => {
    expect(failureDifferences(board, 0, 1, pairsOf(board, 0, 1, 100))).toEqual([-0.5, 1]);
  });
});
