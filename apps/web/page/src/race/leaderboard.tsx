// The leaderboard of a race in one world.
import { useMemo } from 'preact/hooks';
import type { RaceGroup } from '../core/types';
import { isNumber } from '../ui/format';
import { columnsOf, orderedBy } from './leaderboard-columns';
import { Legend, SortedTable } from '../ui/sorted-table';
import { Scrolling } from '../ui/table';
import { worldOf } from '../results/worlds';

/** What `labmouse race` says below its table; where the results lack it, how mice are scored. */
function notesOf({ notes, world, formula, failure_score: failed }: RaceGroup): string[] {
  if (notes?.length) return notes;
  const failures = isNumber(failed)
    ? `A failed contest counts ${failed}.`
    : 'Failed contests are left out of all means.';
  return [`World ${world}. Score: ${formula}; lower is better. ${failures}`];
}

interface Props {
  group: RaceGroup;
  /** Marked: one's mouse, and what it was before. */
  own?: string[];
  /** All races of these results. */
  among?: RaceGroup[];
  /** Only mice whose names have it are seen. */
  search?: string;
  /** Gets the positions of the mice in their new order. */
  onOrder?(order: number[]): void;
}

const ownClasses = ['own', 'own before'];

export function Leaderboard({ group, own = [], among = [], search = '', onOrder }: Props) {
  const { title, bound } = worldOf(group, among);
  const label = `Leaderboard${title}`;
  const mazes = group.mazes.filter((maze) => isNumber(bound(maze))).length;
  const columns = useMemo(() => columnsOf(group, mazes, own), [group, own.join()]);
  return (
    <div>
      <Scrolling label={`${label}, table`}>
        <SortedTable
          caption={label}
          heard
          columns={columns}
          rows={group.mice}
          by={orderedBy(group)}
          rowClass={({ name, contestant }) => (contestant === false ? 'reference' : ownClasses[own.indexOf(name)])}
          pass={({ name }) => name.toLowerCase().includes(search.toLowerCase())}
          onOrder={onOrder && ((rows) => onOrder(rows.map((row) => group.mice.indexOf(row))))}
        />
      </Scrolling>
      <p class="note lines">{notesOf(group).join('\n')}</p>
      <Legend columns={columns} />
    </div>
  );
}
