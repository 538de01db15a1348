// The matrix: a row for each mouse, a column for each maze.
import { button, select } from '../ui/controls';
import { h } from '../ui/dom';
import { paperWidth } from '../ui/tones';
import { cellText, contestText } from './cell-text';
import type { Board } from '../results/contests';
import { cellAt, matrixLayout, moved, widthFor, type Layout, type Place, type Width } from './matrix-layout';
import { matrixLegend } from './matrix-legend';
import { paintMatrix } from './matrix-paint';
import { mazeOrders, orderedMazes, type MazeOrder } from './maze-order';

export type Matrix = ReturnType<typeof matrix>;

type Open = (mouse: number, maze: number, contest: number) => void;

/** What is shown of a board: rows and columns as positions of mice and mazes, where they lie, and the chosen cell. */
interface Shown {
  board: Board;
  mice: number[];
  mazes: number[];
  layout: Layout;
  cursor: Place;
}

const inBoard = ({ mice, mazes }: Shown, { row, column }: Place) => [mice[row], mazes[column]] as const;

/** The cells, and where the pointer is among them. */
function createGrid(shown: Shown) {
  const { board } = shown;
  const canvas = h('canvas', { 'aria-hidden': 'true' });
  const mark = h('div.mark', { hidden: true });
  const label = `${board.mice.length} mice by ${board.mazes.length} mazes. Arrow keys move from cell to cell, Enter opens the replay.`;
  const element = h(
    'div.cells',
    { tabindex: 0, role: 'application', 'aria-roledescription': 'matrix', 'aria-label': label },
    canvas,
    mark,
  );
  return {
    element,
    canvas,
    mark,
    placeOf(event: MouseEvent) {
      const area = element.getBoundingClientRect();
      return cellAt(shown.layout, event.clientX - area.left, event.clientY - area.top);
    },
    showMark() {
      const { cursor, layout } = shown;
      mark.hidden = false;
      mark.style.left = `${cursor.column * layout.cellWidth}px`;
      mark.style.top = `${layout.top + cursor.row * layout.cellHeight}px`;
      mark.style.width = `${layout.cellWidth}px`;
      mark.style.height = `${layout.cellHeight}px`;
    },
  };
}

type Grid = ReturnType<typeof createGrid>;

/** What the chosen cell says, and the contests in it. */
function createReading(shown: Shown, grid: Grid, open: Open) {
  const { board } = shown;
  const caption = h('p.caption', { 'aria-live': 'polite' }, 'Point at a cell, or move with the arrow keys.');
  const opener = button('Open the replay', () => openAt(shown.cursor), { disabled: true });
  const runs = h('ol.runs', { hidden: true });
  function select(place: Place) {
    const [mouse, maze] = inBoard(shown, place);
    shown.cursor = place;
    caption.textContent = cellText(board, mouse, maze);
    opener.disabled = board.cells[mouse][maze].contests.length === 0;
    runs.hidden = true;
    grid.showMark();
  }
  /** One contest opens at once; of several, one is chosen from a list. */
  function openAt(place: Place) {
    const [mouse, maze] = inBoard(shown, place);
    const { contests } = board.cells[mouse][maze];
    if (contests.length <= 1) return contests.length === 1 && open(mouse, maze, 0);
    const { optimum } = board.mazes[maze];
    runs.replaceChildren(
      ...contests.map((contest, position) =>
        h(
          'li',
          button(contestText(contest, optimum), () => open(mouse, maze, position)),
        ),
      ),
    );
    runs.hidden = false;
    runs.querySelector('button')?.focus();
  }
  runs.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    runs.hidden = true;
    grid.element.focus({ preventScroll: true });
  });
  /** No cell is chosen any more. */
  function clear() {
    grid.mark.hidden = runs.hidden = opener.disabled = true;
    shown.cursor = { row: 0, column: 0 };
  }
  return { line: h('div.row.reading.controls', caption, opener), runs, select, openAt, clear };
}

/** Pointer and keys; `went` hears of a move by a key. */
function listen(
  shown: Shown,
  { element, mark, placeOf }: Grid,
  reading: ReturnType<typeof createReading>,
  went: () => void,
) {
  const { runs, select, openAt } = reading;
  const isEmpty = () => shown.mice.length === 0 || shown.mazes.length === 0;
  let byTouch = false;
  element.addEventListener('pointermove', (event) => {
    const place = event.pointerType === 'mouse' && runs.hidden ? placeOf(event) : null;
    const { cursor } = shown;
    if (place && (place.row !== cursor.row || place.column !== cursor.column || mark.hidden)) select(place);
  });
  element.addEventListener('pointerdown', (event) => (byTouch = event.pointerType === 'touch'));
  element.addEventListener('click', (event) => {
    const place = placeOf(event);
    if (!place) return;
    select(place);
    // A finger cannot hover: it chooses the cell, the button below opens it.
    if (!byTouch) openAt(place);
  });
  element.addEventListener('focus', () => !isEmpty() && mark.hidden && !byTouch && select(shown.cursor));
  element.addEventListener('keydown', (event) => {
    if (isEmpty()) return;
    if (event.key === 'Enter') return (event.preventDefault(), void openAt(shown.cursor));
    const next = moved(shown.cursor, event.key, shown.layout);
    if (!next || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    select(next);
    went();
  });
}

/** Scrolls to the chosen column, in a box with that room for columns. */
function bringIntoSight(box: HTMLElement, room: number, { cursor, layout: { cellWidth } }: Shown) {
  const left = cursor.column * cellWidth;
  if (left < box.scrollLeft) box.scrollLeft = left;
  else if (left + cellWidth > box.scrollLeft + room) box.scrollLeft = left + cellWidth - room;
}

/** `open` shows the contest of that mouse in that maze; the last is its position among several. */
export function matrix(board: Board, open: Open) {
  let order = board.mice.map(({ index }) => index);
  let filterText = '';
  let width: Width | null = null;
  const [start, letters] = [{ row: 0, column: 0 }, Math.max(0, ...board.mazes.map(({ short }) => short.length))];
  const mazes = orderedMazes(board, 'name');
  const layout = matrixLayout(mazes.length, order.length, 600, 'fit');
  const shown: Shown = { board, mice: order, mazes, layout, cursor: start };
  const grid = createGrid(shown);
  const reading = createReading(shown, grid, open);
  const names = h('div.names', { 'aria-hidden': 'true' });
  const box = h('div.matrix', names, grid.element);
  listen(shown, grid, reading, () => bringIntoSight(box, box.clientWidth - names.offsetWidth, shown));

  function arrange() {
    const text = filterText.toLowerCase();
    const mice = order.filter((mouse) => board.mice[mouse].name.toLowerCase().includes(text));
    const mazes = orderedMazes(board, orders.value as MazeOrder);
    names.replaceChildren(...mice.map((mouse) => h('div', { title: board.mice[mouse].name }, board.mice[mouse].short)));
    // What is hidden has no width; it is arranged again when it is shown.
    const paper = paperWidth();
    const room = (paper ?? (box.clientWidth || 600)) - (names.offsetWidth || 150);
    if (width === null && !paper && box.clientWidth > 0)
      wide.checked = (width = widthFor(mazes.length, room)) === 'wide';
    const layout = matrixLayout(mazes.length, mice.length, room, paper ? 'paper' : (width ?? 'fit'), letters);
    Object.assign(shown, { mice, mazes, layout });
    names.style.paddingTop = `${layout.top}px`;
    paintMatrix(grid.canvas, { board, mice, mazes, layout });
    if (!grid.mark.hidden) grid.showMark();
  }
  /** Arranges for other rows or columns, so that the cursor stands nowhere any more. */
  function rearrange() {
    reading.clear();
    arrange();
  }
  const orders = select(
    mazeOrders.map((name) => [name, name]),
    rearrange,
  );
  const wide = h('input', { type: 'checkbox', onchange: () => ((width = wide.checked ? 'wide' : 'fit'), arrange()) });
  const [by, cells] = [h('label.row', 'Mazes by', orders), h('label.row', wide, 'wide cells')];
  return {
    element: h('div', h('div.row.controls', by, cells), box, reading.line, reading.runs, matrixLegend()),
    /** The rows, as positions of mice. */
    order: (to: number[]) => ((order = to), rearrange()),
    filter: (text: string) => ((filterText = text), rearrange()),
    /** Paints anew, for the room that is there now. */
    arrange,
  };
}
