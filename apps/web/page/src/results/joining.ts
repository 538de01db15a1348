// The pieces of a race that was held in the page, one mouse each, as one race.
import type { RaceGroup, RaceResults } from '../core/types';
import { orNull } from '../ui/format';
import { sorted } from '../ui/sorting';
import { worldOf } from './worlds';

/** Where a contest without a score has no place in means, mice that scored in more contests come first. */
function inOrder(group: RaceGroup, mice: RaceGroup['mice']): RaceGroup['mice'] {
  const { mean, countsFailures } = worldOf(group);
  const byMean = sorted(mice, (mouse) => orNull(mouse[mean.key]), 'ascending');
  return countsFailures ? byMean : sorted(byMean, (mouse) => orNull(mouse.finished), 'descending');
}

/** All mice of those races in the same mazes, best first; null where there is no race. */
export function joined(pieces: RaceResults[], stopped: boolean): RaceResults | null {
  if (pieces.length === 0) return null;
  const [first] = pieces;
  const groups = first.groups.map((group, index) => ({
    ...group,
    // They speak of the race as a whole, so those of pieces cannot be put together.
    notes: pieces.length === 1 ? group.notes : undefined,
    mice: inOrder(
      group,
      pieces.flatMap((piece) => piece.groups[index]?.mice ?? []),
    ),
  }));
  return { ...first, stopped: stopped || pieces.some((piece) => piece.stopped), groups };
}

/** Races that differ in a setting of their world, as one result with a group for each. */
export function sideBySide(races: RaceResults[]): RaceResults {
  const [first] = races;
  return { ...first, groups: races.flatMap(({ groups }) => groups) };
}
