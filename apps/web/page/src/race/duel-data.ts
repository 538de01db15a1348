// Two mice in the same mazes.
import type { Board, Cell } from './contests';
import { meanOf } from './contests';

export interface Pair {
  maze: number;
  /** Mean scores over all contests, failed ones counted. */
  a: number;
  b: number;
  difference: number;
}

/** The mean score in a maze as races count it: `failure` for a failed contest, which is left out where that is null. */
const scoreOf = ({ contests }: Cell, failure: number | null) =>
  meanOf(contests.flatMap(({ score }) => score ?? failure ?? []));

/** Every maze with a route in which both raced, in the order of the mazes. */
export function pairsOf({ mazes, cells }: Board, a: number, b: number, failure: number | null): Pair[] {
  return mazes.flatMap(({ index, bound }) => {
    const [first, second] = [scoreOf(cells[a][index], failure), scoreOf(cells[b][index], failure)];
    return bound === null || first === null || second === null
      ? []
      : [{ maze: index, a: first, b: second, difference: first - second }];
  });
}
