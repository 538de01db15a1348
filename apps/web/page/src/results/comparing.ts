// Compares mice until it is decided which is better, batch by batch, so that the page responds between batches.
import { Stopped, type Core } from '../core/client';
import type { Comparison, ComparisonOrder, Fields, Shares } from '../core/types';

/** What is compared, by the mice in it: the first one is compared with all others. */
export type ComparisonRequest = ComparisonOrder & Fields;

/** How the test decides, as typed: the options of `labmouse compare`. */
export interface TestFields {
  betterBy: string;
  alpha: string;
  beta: string;
  /** Mazes. */
  most: string;
  test: string;
}

/** As on the command line. */
export const usualTest: TestFields = { betterBy: '0.02', alpha: '0.05', beta: '0.05', most: '5000', test: 'bets' };

/** The same as the core takes it. */
export const testOf = ({ betterBy, alpha, beta, most, test }: TestFields) => ({
  better_by: Number(betterBy),
  alpha: Number(alpha),
  beta: Number(beta),
  most: Number(most),
  test,
});

/** The answer of a call; null where it was stopped. */
const unlessStopped = <Answer>(answer: Promise<Answer>): Promise<Answer | null> =>
  answer.catch((error) => {
    if (error instanceof Stopped) return null;
    throw error;
  });

/**
 * Calls `report` after each batch, and continues while `wanted` returns true. Returns null if it is stopped in the first
 * batch.
 */
export async function compareMice(
  core: Core,
  request: ComparisonRequest,
  report: (comparison: Comparison) => void,
  wanted: () => boolean,
): Promise<Comparison | null> {
  const shares: Shares = [];
  let comparison: Comparison | null = null;
  for (let isOver = false; !isOver && wanted();) {
    const isOpen = (place: number) =>
      place === 0 || comparison === null || comparison.candidates[place - 1].verdict === 'undecided';
    const open = request.mice.map((_, place) => place).filter(isOpen);
    const mice = open.map((place) => request.mice[place]);
    const batch = await unlessStopped(core.call('paired_shares', { ...request, mice, begin: shares.length }));
    if (!batch) break;
    for (const row of batch.shares) shares.push(request.mice.map((_, place) => row[open.indexOf(place)] ?? null));
    const verdict = await unlessStopped(core.call('verdict', { ...request, shares }));
    if (!verdict) break;
    ({ comparison, over: isOver } = verdict);
    report(comparison);
  }
  return comparison;
}
