// A table whose columns sort it: a button in each head, and what the column means as its title.
import { h, type Child } from './dom';
import { sorted, type Direction, type SortValue } from './sorting';

export interface Column<Row> {
  title: string;
  meaning: string;
  value: (row: Row) => SortValue;
  /** What stands in the cell; the value where it is left out. */
  show?: (row: Row) => Child;
  /** What stands below the button in the head. */
  head?: () => Child;
  /** How its best values are found first. */
  best: Direction;
  class?: string;
}

interface TableOptions<Row> {
  /** Seen, or only heard. */
  caption: HTMLTableCaptionElement | string;
  columns: Column<Row>[];
  rows: Row[];
  /** The column by which it is sorted at first. */
  by: number;
  rowClass?: (row: Row) => string;
  /** Told of a row that was clicked. */
  pick?: (row: Row) => void;
  /** Told the new order after each sorting. */
  onOrder?: (rows: Row[]) => void;
}

/** The first column names the row. */
export function sortedTable<Row>({ caption, columns, rows: first, by, rowClass, pick, onOrder }: TableOptions<Row>) {
  let direction = columns[by].best;
  const rows = [...first];
  const lineOf = (row: Row) =>
    h(
      'tr',
      { class: rowClass?.(row) || null, onclick: pick && (() => pick(row)) },
      ...columns.map(({ value, show, class: name }, place) => {
        const content = show ? show(row) : value(row);
        return place === 0 ? h('th', { scope: 'row', class: name }, content) : h('td', { class: name }, content);
      }),
    );
  const lines = new Map(rows.map((row) => [row, lineOf(row)]));
  const heads = columns.map(({ title, meaning, head, class: name }, place) =>
    h(
      'th',
      { scope: 'col', class: name },
      h('button', { type: 'button', title: meaning, onclick: () => sort(place) }, title),
      head?.(),
    ),
  );
  const body = h('tbody');

  function sort(place: number) {
    direction = place !== by ? columns[place].best : direction === 'ascending' ? 'descending' : 'ascending';
    by = place;
    arrange();
  }
  function arrange() {
    const order = sorted(rows, columns[by].value, direction);
    body.replaceChildren(...order.map((row) => lines.get(row)!));
    heads.forEach((head, place) =>
      place === by ? head.setAttribute('aria-sort', direction) : head.removeAttribute('aria-sort'),
    );
    onOrder?.(order);
  }
  arrange();
  return {
    element: h(
      'table.sorted',
      typeof caption === 'string' ? h('caption.unseen', caption) : caption,
      h('thead', h('tr', ...heads)),
      body,
    ),
    /** Shows only rows that pass; all are there for sorting. */
    filter(pass: (row: Row) => boolean) {
      for (const [row, line] of lines) line.hidden = !pass(row);
    },
    add(row: Row) {
      rows.push(row);
      lines.set(row, lineOf(row));
      arrange();
    },
  };
}

/** What the columns mean, for all who cannot hover. */
export const legendOf = (columns: Column<never>[]) =>
  h(
    'details.legend.controls',
    h('summary', 'What the columns mean'),
    h('dl', ...columns.flatMap(({ title, meaning }) => [h('dt', title), h('dd', meaning)])),
  );
