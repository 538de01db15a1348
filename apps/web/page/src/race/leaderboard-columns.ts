// The columns of the leaderboards, and what they mean.
import type { MmsGroup, RacedMouse } from '../core/types';
import { h } from '../ui/dom';
import { isNumber, number } from './format';
import type { Column } from './sorted-table';
import { whiskers } from './whisker';

export type MmsMouse = MmsGroup['mice'][number];

const orNull = (value: unknown) => (isNumber(value) ? value : null);

function nameColumn<Row extends { name: string }>(reference: (row: Row) => boolean): Column<Row> {
  return {
    title: 'mouse',
    meaning: 'Its name, with the parameters that were given. A reference knows the maze and is no contestant.',
    value: (row) => row.name,
    show: (row) =>
      h('span', { class: 'name', title: row.name }, row.name, reference(row) && h('small', {}, 'reference')),
    best: 'ascending',
    class: 'first',
  };
}

const solvedColumn = <Row extends { solved: number; runs: number }>(): Column<Row> => ({
  title: 'solved',
  meaning: 'Contests that ended in the goal, of all contests in mazes with a route.',
  value: (row) => orNull(row.solved / row.runs),
  show: (row) => `${number(row.solved, 0)} of ${number(row.runs, 0)}`,
  best: 'descending',
});

const figure = <Row>(
  title: string,
  meaning: string,
  pick: (row: Row) => unknown,
  digits: number,
  best: Column<Row>['best'] = 'ascending',
): Column<Row> => ({
  title,
  meaning,
  value: (row) => orNull(pick(row)),
  show: (row) => number(pick(row), digits),
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
    meaning:
      'Where the mean score over all lies: percentile bootstrap over the mazes. The dot is the mean; lower is better.',
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

/** Those of our own rules. */
export function columnsOf(mice: RacedMouse[], mazes: number): Column<RacedMouse>[] {
  return [
    nameColumn<RacedMouse>((mouse) => mouse.contestant === false),
    solvedColumn(),
    figure(
      'score, all',
      'Mean score over all contests, in steps: speed run plus a thirtieth of the exploration; a failed one counts 100.',
      (m) => m.penalised_mean,
      3,
    ),
    intervalColumn(
      mice,
      (m) => m.penalised_mean,
      (m) => m.interval,
      mazes,
      'steps',
    ),
    figure('score, solved', 'Mean score over the solved contests, in steps.', (m) => m.mean_score, 3),
    figure(
      'score / bound',
      'Mean over the solved contests of the score over the best possible one in that maze.',
      (m) => m.mean_ratio,
      3,
    ),
    figure(
      'explor. steps',
      'Mean exploration steps of the solved contests, the reset included.',
      (m) => m.mean_exploration_steps,
      1,
    ),
    figure(
      'speed + steps',
      "Mean steps of the solved contests' speed runs beyond the shortest.",
      (m) => m.mean_speed_over_optimum,
      2,
    ),
    figure(
      'best runs, %',
      'Percent of all contests whose speed run was a shortest one.',
      (m) => isNumber(m.optimal_share) && 100 * m.optimal_share,
      1,
      'descending',
    ),
    figure(
      'µs a step',
      'Mean time of a decision, in microseconds: the one figure that differs from race to race.',
      (m) => m.microseconds_per_decision,
      2,
    ),
  ];
}

/** Those of mms. */
export function mmsColumns(mice: MmsMouse[], mazes: number): Column<MmsMouse>[] {
  return [
    nameColumn<MmsMouse>(() => false),
    solvedColumn(),
    figure(
      'score, all',
      'Mean score of mms over all runs; an unsolved one counts 2000, as in mms.',
      (m) => m.mean_score,
      3,
    ),
    intervalColumn(
      mice,
      (m) => m.mean_score,
      (m) => m.interval,
      mazes,
      'score of mms',
    ),
    figure(
      'score / best',
      'Mean over the solved runs of the score over the best possible one in that maze.',
      (m) => m.mean_ratio,
      3,
    ),
    figure('best run', 'Mean of the best runs from start to goal, in steps of mms.', (m) => m.mean_best_run, 1),
  ];
}
