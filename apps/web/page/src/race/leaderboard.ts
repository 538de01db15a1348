// The leaderboards: one of our own rules, one of mms.
import type { MmsGroup, RaceResults } from '../core/types';
import { h } from '../ui/dom';
import { isNumber } from './format';
import { columnsOf, mmsColumns } from './leaderboard-columns';
import { legendOf, sortedTable, type Column, type SortedTable } from './sorted-table';

export interface Leaderboard {
  element: HTMLElement;
  filter(text: string): void;
}

function boxed<Row extends { name: string }>(
  table: SortedTable<Row>,
  columns: Column<Row>[],
  label: string,
  notes: string[],
): Leaderboard {
  return {
    element: h(
      'div',
      {},
      h('div', { class: 'box', tabindex: 0, role: 'region', 'aria-label': `${label}, table` }, table.element),
      h('p', { class: 'note lines' }, notes.join('\n')),
      legendOf(columns),
    ),
    filter: (text) => table.filter((row) => row.name.toLowerCase().includes(text.toLowerCase())),
  };
}

/** What `labmouse race` says below its table; where the results lack it, what it always says. */
function notesOf({ notes }: RaceResults): string[] {
  if (Array.isArray(notes) && notes.length > 0) return notes.map(String);
  return [
    'Score: speed-run steps + exploration steps / 30; lower is better.',
    "A failed contest counts 100 in 'all' and is left out of 'solved'.",
  ];
}

/** Our own rules. `onOrder` is told the positions of the mice in their new order. */
export function leaderboard(results: RaceResults, onOrder: (order: number[]) => void): Leaderboard {
  const mazes = results.mazes.filter(({ bound }) => isNumber(bound)).length;
  const columns = columnsOf(results.mice, mazes);
  const place = new Map(results.mice.map((mouse, index) => [mouse, index]));
  const table = sortedTable({
    caption: 'Leaderboard',
    columns,
    rows: results.mice,
    by: 2,
    rowClass: (mouse) => (mouse.contestant === false ? 'reference' : ''),
    onOrder: (rows) => onOrder(rows.map((row) => place.get(row)!)),
  });
  return boxed(table, columns, 'Leaderboard', notesOf(results));
}

/** The world of mms. */
export function mmsLeaderboard(group: MmsGroup): Leaderboard {
  const columns = mmsColumns(group.mice, group.mazes.length);
  const caption = 'Leaderboard of mms';
  return boxed(sortedTable({ caption, columns, rows: group.mice, by: 2 }), columns, caption, [
    `Mice of mms. Score: ${group.formula}; lower is better.`,
  ]);
}
