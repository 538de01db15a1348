// The matrix: a row for each mouse, a column for each maze.
import { h } from '../ui/dom';
import { paperWidth } from '../ui/tones';
import { cellText, contestText } from './cell-text';
import type { Board } from '../results/contests';
import { cellAt, matrixLayout, moved, widthFor, type Layout, type Place, type Width } from './matrix-layout';
import { matrixLegend } from './matrix-legend';
import { paintMatrix } from './matrix-paint';
import { mazeOrders, orderedMazes, type MazeOrder } from './maze-order';

export interface Matrix {
  element: HTMLElement;
  /** The rows, as positions of mice. */
  order(mice: number[]): void;
  filter(text: string): void;
  /** Paints anew, for the room that is there now. */
  arrange(): void;
}

/** `open` shows the contest of that mouse in that maze; the last is its position among several. */
export function matrix(board: Board, open: (mouse: number, maze: number, contest: number) => void): Matrix {
  let mice = board.mice.map(({ index }) => index);
  let order = mice;
  let mazeOrder: MazeOrder = 'name';
  let mazes = orderedMazes(board, mazeOrder);
  let width: Width | null = null;
  let filterText = '';
  let layout: Layout = matrixLayout(mazes.length, mice.length, 600, 'fit');
  let cursor: Place = { row: 0, column: 0 };
  const letters = Math.max(0, ...board.mazes.map(({ short }) => short.length));
  const { best } = board.shows;

  const canvas = h('canvas', { 'aria-hidden': 'true' });
  const mark = h('div', { class: 'mark', hidden: true });
  const names = h('div', { class: 'names', 'aria-hidden': 'true' });
  const grid = h(
    'div',
    {
      class: 'cells',
      tabindex: 0,
      role: 'application',
      'aria-roledescription': 'matrix',
      'aria-label': `${board.mice.length} mice by ${board.mazes.length} mazes. Arrow keys move from cell to cell, Enter opens the replay.`,
    },
    canvas,
    mark,
  );
  const box = h('div', { class: 'matrix' }, names, grid);
  const caption = h('p', { class: 'caption', 'aria-live': 'polite' }, 'Point at a cell, or move with the arrow keys.');
  const opener = h('button', { type: 'button', disabled: true, onclick: () => openAt(cursor) }, 'Open the replay');
  const runs = h('ol', { class: 'runs', hidden: true });

  const mouseAt = ({ row }: Place) => mice[row];
  const mazeAt = ({ column }: Place) => mazes[column];

  function select(place: Place) {
    cursor = place;
    caption.textContent = cellText(board, mouseAt(place), mazeAt(place));
    opener.disabled = board.cells[mouseAt(place)][mazeAt(place)].contests.length === 0;
    runs.hidden = true;
    showMark();
  }
  function showMark() {
    mark.hidden = false;
    mark.style.left = `${cursor.column * layout.cellWidth}px`;
    mark.style.top = `${layout.top + cursor.row * layout.cellHeight}px`;
    mark.style.width = `${layout.cellWidth}px`;
    mark.style.height = `${layout.cellHeight}px`;
  }
  function bringIntoSight() {
    const left = cursor.column * layout.cellWidth;
    const room = box.clientWidth - names.offsetWidth;
    if (left < box.scrollLeft) box.scrollLeft = left;
    else if (left + layout.cellWidth > box.scrollLeft + room) box.scrollLeft = left + layout.cellWidth - room;
  }
  /** One contest opens at once; of several, one is chosen from a list. */
  function openAt(place: Place) {
    const [mouse, maze] = [mouseAt(place), mazeAt(place)];
    const { contests } = board.cells[mouse][maze];
    if (contests.length <= 1) return contests.length === 1 && open(mouse, maze, 0);
    runs.replaceChildren(
      ...contests.map((contest, position) =>
        h(
          'li',
          {},
          h(
            'button',
            { type: 'button', onclick: () => open(mouse, maze, position) },
            contestText(contest, board.mazes[maze].optimum),
          ),
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
    grid.focus({ preventScroll: true });
  });

  const placeOf = (event: MouseEvent) => {
    const area = grid.getBoundingClientRect();
    return cellAt(layout, event.clientX - area.left, event.clientY - area.top);
  };
  let byTouch = false;
  grid.addEventListener('pointermove', (event) => {
    const place = event.pointerType === 'mouse' && runs.hidden ? placeOf(event) : null;
    if (place && (place.row !== cursor.row || place.column !== cursor.column || mark.hidden)) select(place);
  });
  grid.addEventListener('pointerdown', (event) => (byTouch = event.pointerType === 'touch'));
  grid.addEventListener('click', (event) => {
    const place = placeOf(event);
    if (!place) return;
    select(place);
    // A finger cannot hover: it chooses the cell, the button below opens it.
    if (!byTouch) openAt(place);
  });
  grid.addEventListener(
    'focus',
    () => mice.length > 0 && mazes.length > 0 && mark.hidden && !byTouch && select(cursor),
  );
  grid.addEventListener('keydown', (event) => {
    if (mice.length === 0 || mazes.length === 0) return;
    if (event.key === 'Enter') return (event.preventDefault(), void openAt(cursor));
    const next = moved(cursor, event.key, layout);
    if (!next || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    select(next);
    bringIntoSight();
  });

  function arrange() {
    const text = filterText.toLowerCase();
    mice = order.filter((mouse) => board.mice[mouse].name.toLowerCase().includes(text));
    mazes = orderedMazes(board, mazeOrder);
    names.replaceChildren(...mice.map((mouse) => h('div', { title: board.mice[mouse].name }, board.mice[mouse].short)));
    // What is hidden has no width; it is arranged again when it is shown.
    const paper = paperWidth();
    const room = (paper ?? (box.clientWidth || 600)) - (names.offsetWidth || 150);
    if (width === null && !paper && box.clientWidth > 0)
      wideChoice.checked = (width = widthFor(mazes.length, room)) === 'wide';
    layout = matrixLayout(mazes.length, mice.length, room, paper ? 'paper' : (width ?? 'fit'), letters);
    names.style.paddingTop = `${layout.top}px`;
    paintMatrix(canvas, { board, mice, mazes, layout });
    if (!mark.hidden) showMark();
  }
  /** Arranges for other rows or columns, so that the cursor stands nowhere any more. */
  function rearrange() {
    mark.hidden = true;
    runs.hidden = true;
    opener.disabled = true;
    cursor = { row: 0, column: 0 };
    arrange();
  }

  const orderChoice = h(
    'select',
    { onchange: () => ((mazeOrder = orderChoice.value as MazeOrder), rearrange()) },
    ...mazeOrders.map((name) => h('option', { value: name }, name)),
  );
  const wideChoice = h('input', {
    type: 'checkbox',
    onchange: () => ((width = wideChoice.checked ? 'wide' : 'fit'), arrange()),
  });
  const element = h(
    'div',
    {},
    h(
      'div',
      { class: 'row controls' },
      h('label', { class: 'row' }, 'Mazes by', orderChoice),
      h('label', { class: 'row' }, wideChoice, 'wide cells'),
    ),
    box,
    h('div', { class: 'row reading controls' }, caption, opener),
    runs,
    matrixLegend(best),
  );
  return {
    element,
    order: (to) => ((order = to), rearrange()),
    filter: (text) => ((filterText = text), rearrange()),
    arrange,
  };
}
