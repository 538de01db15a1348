// The matrix: a row for each mouse, a column for each maze.
import type { RefObject } from 'preact';
import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { Button, Check, Select } from '../ui/controls';
import { usePainted } from '../ui/painted';
import { paperWidth } from '../ui/tones';
import { cellText, contestText } from './cell-text';
import type { Board } from '../results/contests';
import { cellAt, matrixLayout, moved, widthFor, type Layout, type Place, type Width } from './matrix-layout';
import { MatrixLegend } from './matrix-legend';
import { paintMatrix } from './matrix-paint';
import { mazeOrders, orderedMazes, type MazeOrder } from './maze-order';

interface Props {
  board: Board;
  /** The rows, as positions of mice. */
  order: number[];
  /** Only mice whose names have it are seen. */
  search: string;
  /** Shows the contest of that mouse in that maze; the last is its position among several. */
  open(mouse: number, maze: number, contest: number): void;
}

/** What is shown of a board: rows and columns as positions of mice and mazes, and where they lie. */
interface Shown {
  board: Board;
  mice: number[];
  mazes: number[];
  layout: Layout;
}

/** The chosen cell; null while there is none. */
interface Chosen {
  at: Place;
  /** Whether its contests are listed, to choose one of them. */
  isListed: boolean;
}

interface CellsProps {
  shown: Shown;
  chosen: Chosen | null;
  element: RefObject<HTMLDivElement | null>;
  choose(at: Place): void;
  open(at: Place): void;
  /** Hears of a move by a key. */
  went(to: Place): void;
}

/** The cells: pointer and keys choose one of them. */
const styleOf = ({ row, column }: Place, { top, cellWidth, cellHeight }: Layout) => ({
  left: `${column * cellWidth}px`,
  top: `${top + row * cellHeight}px`,
  width: `${cellWidth}px`,
  height: `${cellHeight}px`,
});

function Cells({ shown, chosen, element, choose, open, went }: CellsProps) {
  const { board, mice, mazes, layout } = shown;
  const canvas = useRef<HTMLCanvasElement>(null);
  const byTouch = useRef(false);
  const isEmpty = mice.length === 0 || mazes.length === 0;
  const at = chosen?.at ?? { row: 0, column: 0 };
  usePainted(canvas, () => paintMatrix(canvas.current!, shown), [mice, mazes, layout]);
  function placeOf(event: MouseEvent) {
    const area = element.current!.getBoundingClientRect();
    return cellAt(layout, event.clientX - area.left, event.clientY - area.top);
  }
  function point(event: PointerEvent) {
    const place = event.pointerType === 'mouse' && !chosen?.isListed ? placeOf(event) : null;
    if (place && (place.row !== at.row || place.column !== at.column || !chosen)) choose(place);
  }
  function click(event: MouseEvent) {
    const place = placeOf(event);
    if (!place) return;
    choose(place);
    // A finger cannot hover: it chooses the cell, the button below opens it.
    if (!byTouch.current) open(place);
  }
  function press(event: KeyboardEvent) {
    if (isEmpty) return;
    if (event.key === 'Enter') return (event.preventDefault(), open(at));
    const next = moved(at, event.key, layout);
    if (!next || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    choose(next);
    went(next);
  }
  const label = `${board.mice.length} mice by ${board.mazes.length} mazes. Arrow keys move from cell to cell, Enter opens the replay.`;
  return (
    <div
      class="cells"
      tabIndex={0}
      role="application"
      aria-roledescription="matrix"
      aria-label={label}
      ref={element}
      onPointerMove={point}
      onPointerDown={(event) => (byTouch.current = event.pointerType === 'touch')}
      onClick={click}
      onFocus={() => !isEmpty && !chosen && !byTouch.current && choose(at)}
      onKeyDown={press}
    >
      <canvas aria-hidden="true" ref={canvas} />
      <div class="mark" hidden={!chosen} style={styleOf(at, layout)} />
    </div>
  );
}

interface RunsProps {
  board: Board;
  mouse: number;
  maze: number;
  open: Props['open'];
  close(): void;
}

/** The contests of a cell, to choose one of them. */
function Runs({ board, mouse, maze, open, close }: RunsProps) {
  const list = useRef<HTMLOListElement>(null);
  useLayoutEffect(() => list.current!.querySelector('button')?.focus(), []);
  function press(event: KeyboardEvent) {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    close();
  }
  return (
    <ol class="runs" ref={list} onKeyDown={press}>
      {board.cells[mouse][maze].contests.map((contest, position) => (
        <li>
          <Button label={contestText(contest, board.mazes[maze].optimum)} act={() => open(mouse, maze, position)} />
        </li>
      ))}
    </ol>
  );
}

/** Scrolls to the chosen column, in a box with that room for columns. */
function bringIntoSight(box: HTMLElement, room: number, { column }: Place, { cellWidth }: Layout) {
  const left = column * cellWidth;
  if (left < box.scrollLeft) box.scrollLeft = left;
  else if (left + cellWidth > box.scrollLeft + room) box.scrollLeft = left + cellWidth - room;
}

/** The layout for the room that there is; what is hidden has no width, and is measured again when it is shown. */
function useLayout(
  box: RefObject<HTMLDivElement | null>,
  names: RefObject<HTMLDivElement | null>,
  { board, mice, mazes }: Omit<Shown, 'layout'>,
) {
  const [width, setWidth] = useState<Width | null>(null);
  const [{ room, isPaper }, setRoom] = useState({ room: 450, isPaper: false });
  function measure() {
    const paper = paperWidth();
    const { clientWidth } = box.current!;
    const room = (paper ?? (clientWidth || 600)) - (names.current!.offsetWidth || 150);
    if (width === null && !paper && clientWidth > 0) setWidth(widthFor(mazes.length, room));
    setRoom({ room, isPaper: paper !== null });
  }
  usePainted(box, measure, [mice, mazes]);
  const letters = Math.max(0, ...board.mazes.map(({ short }) => short.length));
  const layout = useMemo(
    () => matrixLayout(mazes.length, mice.length, room, isPaper ? 'paper' : (width ?? 'fit'), letters),
    [mice, mazes, room, isPaper, width],
  );
  return { layout, width, setWidth };
}

/** What the chosen cell says, and the button that opens its replay. */
const Reading = ({ caption, open }: { caption: string; open: (() => void) | null }) => (
  <div class="row reading controls">
    <p class="caption" aria-live="polite">
      {caption}
    </p>
    <Button label="Open the replay" disabled={!open} act={() => open?.()} />
  </div>
);

/** What is shown, and what is chosen of it. */
function useMatrix({ board, order, search, open }: Props) {
  const [by, sort] = useState<MazeOrder>('name');
  const [chosen, choose] = useState<Chosen | null>(null);
  const [caption, say] = useState('Point at a cell, or move with the arrow keys.');
  const box = useRef<HTMLDivElement>(null);
  const names = useRef<HTMLDivElement>(null);
  const cells = useRef<HTMLDivElement>(null);
  const mice = useMemo(() => {
    const text = search.toLowerCase();
    return order.filter((mouse) => board.mice[mouse].name.toLowerCase().includes(text));
  }, [board, order, search]);
  const mazes = useMemo(() => orderedMazes(board, by), [board, by]);
  const { layout, width, setWidth } = useLayout(box, names, { board, mice, mazes });
  // In other rows or columns no cell is chosen any more.
  useLayoutEffect(() => choose(null), [mice, mazes]);

  const inBoard = ({ row, column }: Place) => [mice[row], mazes[column]] as const;
  const contestsAt = (at: Place) => {
    const [mouse, maze] = inBoard(at);
    return board.cells[mouse]?.[maze]?.contests ?? [];
  };
  function select(at: Place) {
    choose({ at, isListed: false });
    say(cellText(board, ...inBoard(at)));
  }
  /** One contest opens at once; of several, one is chosen from a list. */
  function openAt(at: Place) {
    const { length } = contestsAt(at);
    if (length === 1) open(...inBoard(at), 0);
    else if (length > 1) choose({ at, isListed: true });
  }
  function close() {
    choose(chosen && { ...chosen, isListed: false });
    cells.current!.focus({ preventScroll: true });
  }
  const went = (at: Place) =>
    bringIntoSight(box.current!, box.current!.clientWidth - names.current!.offsetWidth, at, layout);
  const mayOpen = chosen !== null && contestsAt(chosen.at).length > 0;
  return {
    ...{ by, sort, width, setWidth, caption, chosen, box, names, cells, mice, select, openAt, close, went },
    shown: { board, mice, mazes, layout },
    openChosen: mayOpen ? () => openAt(chosen.at) : null,
    listed: chosen?.isListed ? inBoard(chosen.at) : null,
  };
}

export function Matrix(props: Props) {
  const { board, open } = props;
  const { by, sort, width, setWidth, caption, openChosen, listed, ...matrix } = useMatrix(props);
  const { box, names, cells, shown, chosen, select, openAt, close, went } = matrix;
  return (
    <div>
      <div class="row controls">
        <label class="row">
          Mazes by
          <Select options={[...mazeOrders]} value={by} choose={(name) => sort(name as MazeOrder)} />
        </label>
        <Check
          label="wide cells"
          class="row"
          checked={width === 'wide'}
          change={(is) => setWidth(is ? 'wide' : 'fit')}
        />
      </div>
      <div class="matrix" ref={box}>
        <div class="names" aria-hidden="true" ref={names} style={{ paddingTop: `${shown.layout.top}px` }}>
          {shown.mice.map((mouse) => (
            <div title={board.mice[mouse].name}>{board.mice[mouse].short}</div>
          ))}
        </div>
        <Cells {...{ shown, chosen, went }} element={cells} choose={select} open={openAt} />
      </div>
      <Reading caption={caption} open={openChosen} />
      {listed && <Runs mouse={listed[0]} maze={listed[1]} {...{ board, open, close }} />}
      <MatrixLegend />
    </div>
  );
}
