// Where the cells of the matrix lie, in CSS pixels, and how a cursor moves over them.

export interface Layout {
  columns: number;
  rows: number;
  cellWidth: number;
  cellHeight: number;
  /** Room above the cells, for the names of the mazes where they fit. */
  top: number;
  width: number;
  height: number;
}

const rowHeight = 22;
const wideCell = 16;
/** Narrower than that, a cell is hard to see and harder to meet: then cells are wide from the beginning. */
const leastCell = 3;
const mostCell = 32;
/** From this width on, a name stands above its column. */
const leastNamed = 11;
const mostNameRoom = 110;
const letter = 6.5;

/** `paper` fits at any rate: a sheet cannot be scrolled. */
export type Width = 'fit' | 'wide' | 'paper';

/** How wide the cells had better be at first. */
export const widthFor = (columns: number, room: number): Width =>
  room / Math.max(1, columns) < leastCell ? 'wide' : 'fit';

/** For a box of that width and names of at most `letters`. What does not fit is scrolled in it. */
export function matrixLayout(columns: number, rows: number, room: number, width: Width, letters = 20): Layout {
  const fitting = room / Math.max(1, columns);
  const least = { fit: leastCell, wide: wideCell, paper: 1 }[width];
  const cellWidth = Math.min(mostCell, Math.max(least, fitting));
  const top = cellWidth >= leastNamed ? Math.min(mostNameRoom, 14 + letters * letter) : 4;
  return {
    columns,
    rows,
    cellWidth,
    cellHeight: rowHeight,
    top,
    width: cellWidth * columns,
    height: top + rowHeight * rows,
  };
}

export interface Place {
  row: number;
  column: number;
}

/** The cell at that point; null beside all cells. */
export function cellAt(layout: Layout, x: number, y: number): Place | null {
  const column = Math.floor(x / layout.cellWidth);
  const row = Math.floor((y - layout.top) / layout.cellHeight);
  return column >= 0 && column < layout.columns && row >= 0 && row < layout.rows ? { row, column } : null;
}

const moves: Record<string, (place: Place, layout: Layout) => Place> = {
  ArrowLeft: ({ row, column }) => ({ row, column: column - 1 }),
  ArrowRight: ({ row, column }) => ({ row, column: column + 1 }),
  ArrowUp: ({ row, column }) => ({ row: row - 1, column }),
  ArrowDown: ({ row, column }) => ({ row: row + 1, column }),
  PageUp: ({ row, column }) => ({ row, column: column - 10 }),
  PageDown: ({ row, column }) => ({ row, column: column + 10 }),
  Home: ({ row }) => ({ row, column: 0 }),
  End: ({ row }, { columns }) => ({ row, column: columns - 1 }),
};

/** Where that key leads; null for a key that moves nothing. */
export function moved(place: Place, key: string, layout: Layout): Place | null {
  if (!Object.hasOwn(moves, key)) return null;
  const { row, column } = moves[key](place, layout);
  return {
    row: Math.max(0, Math.min(layout.rows - 1, row)),
    column: Math.max(0, Math.min(layout.columns - 1, column)),
  };
}
