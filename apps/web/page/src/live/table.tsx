// The mice of a race in one maze, as a table that can be sorted.
import type { ContestResult } from '../core/types';
import { number, orNull } from '../ui/format';
import { Meanings } from '../ui/meanings';
import { SortedTable, type Column } from '../ui/sorted-table';
import { Scrolling } from '../ui/table';
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
const nameOf = ({ spec, result, isReference }: Row) => (
  <span>
    <button type="button" class="link" title={spec} disabled={!result}>
      {spec}
    </button>
    {isReference && <span class="note"> reference</span>}
  </span>
);

const columns: Column<Row>[] = [
  { title: 'Mouse', meaning: '', value: ({ spec }) => spec, show: nameOf, best: 'ascending' },
  figure('Score', 'steps of the speed run, and a thirtieth of those of the search run', (row) => row.result?.score, 3),
  figure('Score / best', `divided by ${boundMeaning}`, ({ ratio }) => ratio, 3),
  figure('Search', 'steps', (row) => row.result?.search_steps, 0),
  figure('Speed run', 'steps', (row) => row.result?.speed_steps, 0),
  { title: 'Outcome', meaning: '', value: ({ outcome }) => outcome, best: 'ascending', class: 'words' },
];

interface Props {
  caption: string;
  rows: Row[];
  /** Hears of the mouse whose name is clicked, or anything else in its row. */
  pick(row: Row): void;
}

export const RaceTable = ({ caption, rows, pick }: Props) => (
  <div>
    <Scrolling label="Race" class="scroll">
      <SortedTable key={caption} {...{ caption, columns, rows, pick }} by={1} />
    </Scrolling>
    <Meanings of={columns.map(({ title, meaning }) => [title, meaning])} />
  </div>
);
