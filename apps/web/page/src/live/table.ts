// The mice of a race in one maze, as a table that can be sorted.
import type { ContestResult } from '../core/types';
import { h } from '../ui/dom';
import { number, orNull } from '../ui/format';
import { meanings } from '../ui/meanings';
import { sortedTable, type Column } from '../ui/sorted-table';
import { boundMeaning } from '../ui/terms';

export interface Row {
  spec: string;
  /** A measure and no contestant. */
  isReference: boolean;
  /** Null where the mouse could not run; `outcome` says why. */
  result: ContestResult | null;
  ratio: number | null;
  outcome: string;
}

const figure = (title: string, meaning: string, value: (row: Row) => unknown, digits: number): Column<Row> => ({
  title,
  meaning,
  value: (row) => orNull(value(row)),
  show: (row) => number(value(row), digits),
  best: 'ascending',
  class: 'number',
});

/** One that does not run has no walk to be shown. */
const nameOf = ({ spec, result, isReference }: Row) =>
  h(
    'span',
    h('button.link', { type: 'button', title: spec, disabled: !result }, spec),
    isReference && h('span.note', ' reference'),
  );

const columns: Column<Row>[] = [
  { title: 'Mouse', meaning: '', value: ({ spec }) => spec, show: nameOf, best: 'ascending' },
  figure('Score', 'steps of the speed run, and a thirtieth of those of the search run', (row) => row.result?.score, 3),
  figure('Score / best', `divided by ${boundMeaning}`, ({ ratio }) => ratio, 3),
  figure('Search', 'steps', (row) => row.result?.search_steps, 0),
  figure('Speed run', 'steps', (row) => row.result?.speed_steps, 0),
  { title: 'Outcome', meaning: '', value: ({ outcome }) => outcome, best: 'ascending', class: 'words' },
];

/** `pick` hears of the mouse whose name is clicked, or anything else in its row. */
export function createTable(pick: (row: Row) => void) {
  const made = (caption: string) => sortedTable({ caption: h('caption', caption), columns, rows: [], by: 1, pick });
  let table = made('');
  const scroll = h('div.scroll', { tabindex: 0, role: 'region', 'aria-label': 'Race' }, table.element);
  return {
    element: h('div', scroll, meanings(columns.map(({ title, meaning }) => [title, meaning]))),
    begin(caption: string) {
      table = made(caption);
      scroll.replaceChildren(table.element);
    },
    add: (row: Row) => table.add(row),
  };
}
