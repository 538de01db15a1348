// A comparison in the page, batch by batch.
import { expect, it } from 'vitest';
import { Stopped, type Core } from '../../src/core/client';
import type { Comparison, Fields, Shares } from '../../src/core/types';
import { compareMice, testOf, usualTest } from '../../src/results/comparing';

const request = { mice: ['a', 'b', 'c'], seed: 1, most: 6, better_by: 0.1, alpha: 0.05, beta: 0.05 };

/** A core with batches of two mazes. It decides about c after two mazes, and about b after six. */
function coreOf(asked: Fields[], judged: Shares[]): Core {
  const call = async (name: string, given: Fields) => {
    const { mice, begin, shares } = given as { mice: string[]; begin: number; shares: Shares };
    if (name === 'paired_shares') {
      asked.push({ mice, begin });
      return { shares: [begin, begin + 1].map((maze) => mice.map((mouse) => (mouse === 'a' ? 0.5 : maze / 10))) };
    }
    judged.push(structuredClone(shares));
    const verdicts = [shares.length < 6 ? 'undecided' : 'better', 'worse'];
    return { comparison: { candidates: verdicts.map((verdict) => ({ verdict })) }, over: shares.length === 6 };
  };
  return { call } as unknown as Core;
}

it('goes on without decided mice, until it is over', async () => {
  const asked: Fields[] = [];
  const judged: Shares[] = [];
  const seen: Comparison[] = [];
  const compared = await compareMice(
    coreOf(asked, judged),
    request,
    (comparison) => seen.push(comparison),
    () => true,
  );
  expect(asked).toEqual([
    { mice: ['a', 'b', 'c'], begin: 0 },
    { mice: ['a', 'b'], begin: 2 },
    { mice: ['a', 'b'], begin: 4 },
  ]);
  expect(judged[1]).toEqual([
    [0.5, 0, 0],
    [0.5, 0.1, 0.1],
    [0.5, 0.2, null],
    [0.5, 0.3, null],
  ]);
  expect(seen).toHaveLength(3);
  expect(compared!.candidates[0].verdict).toBe('better');
});

it('keeps what is known when it is stopped', async () => {
  const core = coreOf([], []);
  const { call } = core;
  let calls = 0;
  const stopping: Core = {
    ...core,
    call: (...given) => (++calls > 2 ? Promise.reject(new Stopped()) : call(...given)),
  };
  const yes = () => true;
  const compared = await compareMice(stopping, request, () => undefined, yes);
  expect(compared!.candidates[1].verdict).toBe('worse');
  expect(await compareMice(stopping, request, () => undefined, yes)).toBeNull();
  const none: Fields[] = [];
  expect(
    await compareMice(
      coreOf(none, []),
      request,
      () => undefined,
      () => false,
    ),
  ).toBeNull();
  expect(none).toEqual([]);
});

it('asks for the test that is chosen', () => {
  expect(testOf(usualTest)).toEqual({ better_by: 0.02, alpha: 0.05, beta: 0.05, most: 5000, test: 'bets' });
  const chosen = { betterBy: '0.1', alpha: '0.01', beta: '0.2', most: '300', test: 'gsprt' };
  expect(testOf(chosen)).toEqual({ better_by: 0.1, alpha: 0.01, beta: 0.2, most: 300, test: 'gsprt' });
});
