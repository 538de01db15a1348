// The order of a table.

export type Direction = 'ascending' | 'descending';
export type SortValue = number | string | null;

const compareValues = (a: number | string, b: number | string) =>
  typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b), 'en', { numeric: true });

/** A copy in order; what has no value comes last in both directions, equals stay as they were. */
export function sorted<Row>(rows: readonly Row[], value: (row: Row) => SortValue, direction: Direction): Row[] {
  const sign = direction === 'ascending' ? 1 : -1;
  return rows
    .map((row, place) => ({ row, place, value: value(row) }))
    .sort((a, b) => {
      if (a.value === null || b.value === null)
        return Number(a.value === null) - Number(b.value === null) || a.place - b.place;
      return sign * compareValues(a.value, b.value) || a.place - b.place;
    })
    .map(({ row }) => row);
}
