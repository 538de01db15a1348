// The columns of the leaderboards, and what they mean.
import type { RaceGroup, RacedMouse } from '../core/types';
import { number, orNull } from '../ui/format';
import type { Column } from '../ui/sorted-table';
import { whiskers } from './whisker';
import { worldOf, type RacedWorld } from '../results/worlds';

/** Tones alone would not do: the sign of one's own mouse, and of what it was before. */
const ownSigns = ['★ yours', '☆ yours, before'];

function nameColumn(own: string[]): Column<RacedMouse> {
  const signOf = ({ name, contestant }: RacedMouse) =>
    ownSigns[own.indexOf(name)] ?? (contestant === false && 'reference');
  return {
    title: 'mouse',
    meaning: 'Its name, with the parameters that were given. A reference knows the maze and is not a contestant.',
    value: (row) => row.name,
    show: (row) => {
      const sign = signOf(row);
      return (
        <span class="name" title={row.name}>
          {row.name}
          {sign && <small>{sign}</small>}
        </span>
      );
    },
    best: 'ascending',
    class: 'first',
  };
}

const finishedColumn: Column<RacedMouse> = {
  title: 'finished',
  meaning: 'Contests that ended with a score, out of all contests in mazes with a route.',
  value: (row) => orNull(Number(row.finished) / row.runs),
  show: (row) => `${number(row.finished, 0)} of ${number(row.runs, 0)}`,
  best: 'descending',
};

/** The column of intervals; one maze says nothing of others, so it has none. */
function intervalColumn(rows: RacedMouse[], { mean: { key }, unit }: RacedWorld, mazes: number): Column<RacedMouse> {
  const mean = (row: RacedMouse) => row[key];
  const shown = (row: RacedMouse) => (mazes < 2 ? null : row.interval);
  const pictures = whiskers(rows.map((row) => ({ mean: mean(row), interval: shown(row) })));
  return {
    title: `95 % interval, ${unit}`,
    meaning: '95 % interval of the mean score over the mazes. The dot is the mean; lower is better.',
    value: (row) => orNull(shown(row)?.[0]),
    show: (row) => pictures.row(mean(row), shown(row)),
    head: pictures.head,
    best: 'ascending',
    class: 'interval',
  };
}

/**
 * The column by which the program orders mice: where a contest without a score has no place in means, mice that scored in
 * more contests come first, and equals stay as they stand in the results.
 */
export const orderedBy = (group: RaceGroup): number => (worldOf(group).countsFailures ? 2 : 1);

/** Those of a race; the figures of its world stand behind those that all have. `own`: one's mouse, and it before. */
export function columnsOf(group: RaceGroup, mazes: number, own: string[] = []): Column<RacedMouse>[] {
  const world = worldOf(group);
  return [nameColumn(own), finishedColumn, world.mean, intervalColumn(group.mice, world, mazes), ...world.columns];
}
