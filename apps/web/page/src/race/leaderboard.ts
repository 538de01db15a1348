// The leaderboard of a race in one world.
import type { RaceGroup } from '../core/types';
import { h } from '../ui/dom';
import { isNumber } from '../ui/format';
import { columnsOf, orderedBy } from './leaderboard-columns';
import { legendOf, sortedTable } from '../ui/sorted-table';
import { worldOf } from '../results/worlds';

export type Leaderboard = ReturnType<typeof leaderboard>;

/** What `labmouse race` says below its table; where the results lack it, how mice are scored. */
function notesOf({ notes, world, formula, failure_score: failed }: RaceGroup): string[] {
  if (notes?.length) return notes;
  const failures = isNumber(failed)
    ? `A failed contest counts ${failed}.`
    : 'Failed contests are left out of all means.';
  return [`World ${world}. Score: ${formula}; lower is better. ${failures}`];
}

/**
 * `onOrder` gets the positions of the mice in their new order; `own` are marked: one's mouse, and what it was before.
 * `among` are all races of these results.
 */
export function leaderboard(
  group: RaceGroup,
  onOrder: (order: number[]) => void,
  own: string[] = [],
  among: RaceGroup[] = [],
) {
  const { title, bound } = worldOf(group, among);
  const label = `Leaderboard${title}`;
  const columns = columnsOf(group, group.mazes.filter((maze) => isNumber(bound(maze))).length, own);
  const place = new Map(group.mice.map((mouse, index) => [mouse, index]));
  const table = sortedTable({
    caption: label,
    columns,
    rows: group.mice,
    by: orderedBy(group),
    rowClass: (mouse) =>
      mouse.contestant === false ? 'reference' : (['own', 'own before'][own.indexOf(mouse.name)] ?? ''),
    onOrder: (rows) => onOrder(rows.map((row) => place.get(row)!)),
  });
  return {
    world: group.world,
    element: h(
      'div',
      h('div.box', { tabindex: 0, role: 'region', 'aria-label': `${label}, table` }, table.element),
      h('p.note.lines', notesOf(group).join('\n')),
      legendOf(columns),
    ),
    filter: (text: string) => table.filter((row) => row.name.toLowerCase().includes(text.toLowerCase())),
  };
}
