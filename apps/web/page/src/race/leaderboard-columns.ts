// The columns of the leaderboards, and what they mean.
import type { RaceGroup } from '../core/types';
import { h } from '../ui/dom';
import { number, orNull } from '../ui/format';
import type { Column } from './sorted-table';
import { whiskers } from './whisker';
import { worldOf } from '../results/worlds';

type RacedMouse = RaceGroup['mice'][number];

/** Tones alone would not do: the sign of one's own mouse, and of what it was before. */
const ownSigns = ['★ yours', '☆ yours, before'];

function nameColumn<Row extends { name: string }>(reference: (row: Row) => boolean, own: string[]): Column<Row> {
  const signOf = (row: Row) => ownSigns[own.indexOf(row.name)] ?? (reference(row) && 'reference');
  return {
    title: 'mouse',
    meaning: 'Its name, with the parameters that were given. A reference knows the maze and is not a contestant.',
    value: (row) => row.name,
    show: (row) => {
      const sign = signOf(row);
      return h('span', { class: 'name', title: row.name }, row.name, sign && h('small', {}, sign));
    },
    best: 'ascending',
    class: 'first',
  };
}

const solvedColumn = (key: string): Column<RacedMouse> => ({
  title: key,
  meaning: 'Contests that ended with a score, out of all contests in mazes with a route.',
  value: (row) => orNull(Number(row[key]) / row.runs),
  show: (row) => `${number(row[key], 0)} of ${number(row.runs, 0)}`,
  best: 'descending',
});

const figure = <Row>(
  title: string,
  meaning: string,
  pick: (row: Row) => unknown,
  digits: number,
  best: Column<Row>['best'] = 'ascending',
  text = (row: Row) => number(pick(row), digits),
): Column<Row> => ({
  title,
  meaning,
  value: (row) => orNull(pick(row)),
  show: text,
  best,
});

/** The column of intervals; one maze says nothing of others, so it has none. */
function intervalColumn<Row>(
  rows: Row[],
  mean: (row: Row) => unknown,
  interval: (row: Row) => unknown,
  mazes: number,
  unit: string,
): Column<Row> {
  const shown = (row: Row) => (mazes < 2 ? null : interval(row));
  const pictures = whiskers(rows.map((row) => ({ mean: mean(row), interval: shown(row) })));
  return {
    title: `95 % interval, ${unit}`,
    meaning: '95 % interval of the mean score over the mazes. The dot is the mean; lower is better.',
    value: (row) => {
      const found = shown(row);
      return Array.isArray(found) ? orNull(found[0]) : null;
    },
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
  const { mice } = group;
  const mean = (mouse: RacedMouse) => mouse[world.mean];
  return [
    nameColumn<RacedMouse>((mouse) => mouse.contestant === false, own),
    solvedColumn(world.solved),
    figure(world.countsFailures ? 'score, all' : 'score', world.meanMeaning, mean, 3),
    intervalColumn(mice, mean, (mouse) => mouse.interval, mazes, world.unit),
    ...world.columns.map(({ title, meaning, value, digits, best, text }) =>
      figure(title, meaning, value, digits, best, text),
    ),
  ];
}
