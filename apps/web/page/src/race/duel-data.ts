// Two mice in the same mazes.
import type { Board, Cell } from '../results/contests';
import { meanOf } from '../results/contests';

export interface Pair {
  maze: number;
  /** Mean scores over all contests, failed ones counted. */
  a: number;
  b: number;
  difference: number;
}

/** The mean score in a maze: a failed contest counts `limit`, and is left out where that is null. */
const scoreOf = ({ contests }: Cell, limit: number | null) =>
  meanOf(contests.flatMap(({ score }) => score ?? limit ?? []));

/** The share of failed contests. */
const failedShare = ({ contests }: Cell) => contests.filter(({ score }) => score === null).length / contests.length;

/** By how much more often the first failed, for each of the pairs. */
export const failureDifferences = ({ cells }: Board, a: number, b: number, pairs: Pair[]) =>
  pairs.map(({ maze }) => failedShare(cells[a][maze]) - failedShare(cells[b][maze]));

/** Every maze with a route in which both raced, in the order of the mazes. */
export function pairsOf({ mazes, cells }: Board, a: number, b: number, limit: number | null): Pair[] {
  return mazes.flatMap(({ index, bound }) => {
    const [first, second] = [scoreOf(cells[a][index], limit), scoreOf(cells[b][index], limit)];
    return bound === null || first === null || second === null
      ? []
      : [{ maze: index, a: first, b: second, difference: first - second }];
  });
}
