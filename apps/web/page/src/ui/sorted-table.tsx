// A table whose columns sort it: a button in each head, and what the column means as its title.
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useState } from 'preact/hooks';
import { Meanings } from './meanings';
import { sorted, type Direction, type SortValue } from './sorting';
import { Button } from './controls';

export interface Column<Row> {
  title: string;
  meaning: string;
  value: (row: Row) => SortValue;
  /** What stands in the cell; the value where it is left out. */
  show?: (row: Row) => ComponentChildren;
  /** What stands below the button in the head. */
  head?: () => ComponentChildren;
  /** How its best values are found first. */
  best: Direction;
  class?: string;
}

interface TableProps<Row> {
  caption: string;
  /** Whether the caption is only heard. */
  heard?: boolean;
  columns: Column<Row>[];
  rows: Row[];
  /** The column by which it is sorted at first. */
  by: number;
  rowClass?: (row: Row) => string | undefined;
  /** Only such rows are seen; all are there for sorting. */
  pass?: (row: Row) => boolean;
  /** Told of a row that was clicked. */
  pick?: (row: Row) => void;
  /** Told the new order after each sorting. */
  onOrder?: (rows: Row[]) => void;
}

/** The first column names the row. */
export function SortedTable<Row>({ columns, rows, pass, pick, onOrder, ...props }: TableProps<Row>) {
  const [{ by, direction }, sort] = useState({ by: props.by, direction: columns[props.by].best });
  const order = sorted(rows, columns[by].value, direction);
  const other = direction === 'ascending' ? 'descending' : 'ascending';
  useLayoutEffect(() => onOrder?.(order), [by, direction]);
  return (
    <table class="sorted">
      <caption class={props.heard ? 'unseen' : undefined}>{props.caption}</caption>
      <thead>
        <tr>
          {columns.map(({ title, meaning, head, best, class: name }, place) => (
            <th scope="col" class={name} aria-sort={place === by ? direction : undefined}>
              <Button
                label={title}
                title={meaning}
                act={() => sort({ by: place, direction: place === by ? other : best })}
              />
              {head?.()}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {order.map((row) => (
          <tr key={row} class={props.rowClass?.(row)} hidden={pass && !pass(row)} onClick={pick && (() => pick(row))}>
            {columns.map(({ value, show = value, class: name }, place) =>
              place === 0 ? (
                <th scope="row" class={name}>
                  {show(row)}
                </th>
              ) : (
                <td class={name}>{show(row)}</td>
              ),
            )}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** What the columns mean, for all who cannot hover. */
export const Legend = ({ columns }: { columns: Column<never>[] }) => (
  <Meanings class="legend" title="What the columns mean" of={columns.map(({ title, meaning }) => [title, meaning])} />
);
