// The leaderboards: one of our own rules, one of mms.
import type { MmsGroup, RacedMouse, RaceResults } from '../core/types';
import { h } from '../ui/dom';
import { isNumber, number } from './format';
import { legendOf, sortedTable, type Column, type SortedTable } from './sorted-table';
import { whiskers } from './whisker';

type MmsMouse = MmsGroup['mice'][number];

const orNull = (value: unknown) => (isNumber(value) ? value : null);

function nameColumn<Row extends { name: string }>(reference: (row: Row) => boolean): Column<Row> {
  return {
    title: 'mouse',
    meaning: 'Its name, with the parameters that were given. A reference knows the maze and is no contestant.',
    value: (row) => row.name,
    show: (row) => h('span', { class: 'name', title: row.name }, row.name, reference(row) && h('small', {}, 'reference')),
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

const figure = <Row>(title: string, meaning: string, pick: (row: Row) => unknown, digits: number, best: Column<Row>['best'] = 'ascending'): Column<Row> => ({
  title,
  meaning,
  value: (row) => orNull(pick(row)),
  show: (row) => number(pick(row), digits),
  best,
});

/** The column of intervals; one maze says nothing of others, so it has none. */
function intervalColumn<Row>(rows: Row[], mean: (row: Row) => unknown, interval: (row: Row) => unknown, mazes: number, unit: string): Column<Row> {
  const shown = (row: Row) => (mazes < 2 ? null : interval(row));
  const pictures = whiskers(rows.map((row) => ({ mean: mean(row), interval: shown(row) })));
  return {
    title: `95 % interval, ${unit}`,
    meaning: 'Where the mean score over all lies: percentile bootstrap over the mazes. The dot is the mean; lower is better.',
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

function columnsOf(mice: RacedMouse[], mazes: number): Column<RacedMouse>[] {
  return [
    nameColumn<RacedMouse>((mouse) => mouse.contestant === false),
    solvedColumn(),
    figure('score, all', 'Mean score over all contests, in steps: speed run plus a thirtieth of the exploration; a failed one counts 100.', (m) => m.penalised_mean, 3),
    intervalColumn(mice, (m) => m.penalised_mean, (m) => m.interval, mazes, 'steps'),
    figure('score, solved', 'Mean score over the solved contests, in steps.', (m) => m.mean_score, 3),
    figure('score / bound', 'Mean over the solved contests of the score over the best possible one in that maze.', (m) => m.mean_ratio, 3),
    figure('explor. steps', 'Mean exploration steps of the solved contests, the reset included.', (m) => m.mean_exploration_steps, 1),
    figure('speed + steps', "Mean steps of the solved contests' speed runs beyond the shortest.", (m) => m.mean_speed_over_optimum, 2),
    figure('best runs, %', 'Percent of all contests whose speed run was a shortest one.', (m) => isNumber(m.optimal_share) && 100 * m.optimal_share, 1, 'descending'),
    figure('µs a step', 'Mean time of a decision, in microseconds: the one figure that differs from race to race.', (m) => m.microseconds_per_decision, 2),
  ];
}

function mmsColumns(mice: MmsMouse[], mazes: number): Column<MmsMouse>[] {
  return [
    nameColumn<MmsMouse>(() => false),
    solvedColumn(),
    figure('score, all', 'Mean score of mms over all runs; an unsolved one counts 2000, as in mms.', (m) => m.mean_score, 3),
    intervalColumn(mice, (m) => m.mean_score, (m) => m.interval, mazes, 'score of mms'),
    figure('score / best', 'Mean over the solved runs of the score over the best possible one in that maze.', (m) => m.mean_ratio, 3),
    figure('best run', 'Mean of the best runs from start to goal, in steps of mms.', (m) => m.mean_best_run, 1),
  ];
}

export interface Leaderboard {
  element: HTMLElement;
  filter(text: string): void;
}

function boxed<Row extends { name: string }>(table: SortedTable<Row>, columns: Column<Row>[], label: string, note: string): Leaderboard {
  return {
    element: h(
      'div',
      {},
      h('div', { class: 'box', tabindex: 0, role: 'region', 'aria-label': `${label}, table` }, table.element),
      h('p', { class: 'note' }, note),
      legendOf(columns),
    ),
    filter: (text) => table.filter((row) => row.name.toLowerCase().includes(text.toLowerCase())),
  };
}

/** Our own rules. `onOrder` is told the positions of the mice in their new order. */
export function leaderboard(results: RaceResults, onOrder: (order: number[]) => void): Leaderboard {
  const mazes = results.mazes.filter(({ bound }) => isNumber(bound)).length;
  const columns = columnsOf(results.mice, mazes);
  const note = 'Score: speed-run steps + exploration steps / 30; lower is better. A failed contest counts 100 in “all” and is left out of “solved”.';
  const place = new Map(results.mice.map((mouse, index) => [mouse, index]));
  const table = sortedTable({
    caption: 'Leaderboard',
    columns,
    rows: results.mice,
    by: 2,
    rowClass: (mouse) => (mouse.contestant === false ? 'reference' : ''),
    onOrder: (rows) => onOrder(rows.map((row) => place.get(row)!)),
  });
  return boxed(table, columns, 'Leaderboard', note);
}

/** The world of mms. */
export function mmsLeaderboard(group: MmsGroup): Leaderboard {
  const columns = mmsColumns(group.mice, group.mazes.length);
  const caption = 'Leaderboard of mms';
  return boxed(sortedTable({ caption, columns, rows: group.mice, by: 2 }), columns, caption, `Mice of mms. Score: ${group.formula}; lower is better.`);
}
