// The mice of a race in one maze, as a table that can be sorted.
import type { ContestResult } from '../core/types';
import { h } from '../ui/dom';
import { orNull } from '../ui/format';
import { meanings } from '../ui/meanings';
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

export interface Table {
  element: HTMLElement;
  begin(caption: string): void;
  add(row: Row): void;
}

type Value = string | number | null;

interface Column {
  name: string;
  unit: string;
  value: (row: Row) => Value;
  digits?: number;
}

const columns: Column[] = [
  { name: 'Mouse', unit: '', value: (row) => row.spec },
  {
    name: 'Score',
    unit: 'steps of the speed run, and a thirtieth of those of the exploration',
    value: (row) => orNull(row.result?.score),
    digits: 3,
  },
  { name: 'Score / best', unit: `divided by ${boundMeaning}`, value: (row) => row.ratio, digits: 3 },
  { name: 'Exploration', unit: 'steps', value: (row) => orNull(row.result?.exploration_steps), digits: 0 },
  { name: 'Speed run', unit: 'steps', value: (row) => orNull(row.result?.speed_steps), digits: 0 },
  { name: 'Outcome', unit: '', value: (row) => row.outcome },
];

/** Up or down; what is not there comes last both ways. */
export function compareValues(one: Value, other: Value, downwards: boolean): number {
  if (one === null || other === null) return Number(one === null) - Number(other === null);
  const numbers = typeof one === 'number' && typeof other === 'number';
  const order = numbers ? one - other : String(one).localeCompare(String(other));
  return downwards ? -order : order;
}

/** `pick` hears of the mouse whose name is clicked, or anything else in its row. */
export function createTable(pick: (row: Row) => void): Table {
  const caption = h('caption');
  const body = h('tbody');
  const heads = columns.map((column, i) =>
    h(
      'th',
      { scope: 'col' },
      h('button.sorter', { type: 'button', title: column.unit, onclick: () => sortBy(i) }, column.name),
    ),
  );
  const table = h('table', caption, h('thead', h('tr', ...heads)), body);
  const scroll = h('div.scroll', { tabindex: 0, role: 'region', 'aria-label': 'Race' }, table);
  const element = h('div', scroll, meanings(columns.map(({ name, unit }) => [name, unit])));
  let rows: Row[] = [];
  let by = 1;
  let downwards = false;

  function cellOf(column: Column, row: Row, i: number) {
    const value = column.value(row);
    if (i === 0) {
      const show = h('button.link', { type: 'button', title: row.spec, disabled: !row.result }, row.spec);
      return h('th', { scope: 'row' }, show, row.isReference && h('span.note', ' reference'));
    }
    const text = value === null ? '–' : typeof value === 'number' ? value.toFixed(column.digits) : value;
    return h('td', { class: column.digits === undefined ? 'words' : 'number' }, text);
  }
  function show() {
    const { value } = columns[by];
    const sorted = [...rows].sort((one, other) => compareValues(value(one), value(other), downwards));
    heads.forEach((head, i) => {
      if (i === by) head.setAttribute('aria-sort', downwards ? 'descending' : 'ascending');
      else head.removeAttribute('aria-sort');
    });
    body.replaceChildren(
      ...sorted.map((row) => h('tr', { onclick: () => pick(row) }, ...columns.map((one, i) => cellOf(one, row, i)))),
    );
  }
  function sortBy(column: number) {
    downwards = column === by && !downwards;
    by = column;
    show();
  }
  function set(next: Row[]) {
    rows = next;
    show();
  }
  return {
    element,
    begin(words) {
      caption.replaceChildren(words);
      set([]);
    },
    add: (row) => set([...rows, row]),
  };
}
