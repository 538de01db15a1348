// Two mice against each other, maze by maze.
import { useEffect, useRef, useState } from 'preact/hooks';
import type { PairedDifference } from '../core/types';
import { Button, Select } from '../ui/controls';
import { usePainted } from '../ui/painted';
import { paperWidth } from '../ui/tones';
import type { EarlyPage } from '../page/page';
import type { Board } from '../results/contests';
import { paintBars, type Bars } from './duel-bars';
import { failureDifferences, pairsOf, type Pair } from './duel-data';
import { duelWords, failureWords } from './duel-words';
import { errorText, number, scoreText, signed } from '../ui/format';
import { SortedTable } from '../ui/sorted-table';
import { Scrolling } from '../ui/table';

interface Compared {
  a: number;
  b: number;
  pairs: Pair[];
  /** Null where they did not race in the same mazes. */
  found: PairedDifference | null;
  words: string;
}

/** Compares two mice in the order of the mazes, as the command line does: the bootstrap draws by position. */
async function compared(page: EarlyPage, board: Board, a: number, b: number): Promise<Compared> {
  const { unit, limit, countsFailures } = board.shows;
  const pairs = pairsOf(board, a, b, limit);
  const seed = page.race()?.results.seed;
  const compare = (differences: number[]) =>
    page.core.call('compare', { differences, ...(Number.isSafeInteger(seed) && { seed }) });
  if (pairs.length === 0) return { a, b, pairs, found: null, words: 'These two did not race in the same mazes.' };
  const found = await compare(pairs.map(({ difference }) => difference));
  const failed = !countsFailures && limit !== null && (await compare(failureDifferences(board, a, b, pairs)));
  const words = duelWords(board.mice[a].shown, board.mice[b].shown, found, unit);
  return { a, b, pairs, found, words: words + (failed ? failureWords(failed, limit ?? 0, unit) : '') };
}

interface Props {
  board: Board;
  /** Shows both contests beside each other. */
  open(a: number, b: number, maze: number): void;
}

/** The differences as a table, a line for each maze. */
function PairTable({ board, compared: { a, b, pairs }, open }: Props & { compared: Compared }) {
  const { unit } = board.shows;
  const best = 'ascending' as const;
  const scoreColumn = (mouse: number, value: (pair: Pair) => number) => ({
    title: board.mice[mouse].short,
    meaning: `Mean score of ${board.mice[mouse].name} in this maze, in ${unit}.`,
    value,
    show: (pair: Pair) => number(value(pair), 3),
    best,
  });
  const maze = {
    title: 'maze',
    meaning: 'Opens both contests side by side.',
    value: ({ maze }: Pair) => board.mazes[maze].short,
    show: ({ maze }: Pair) => (
      <Button
        label={board.mazes[maze].short}
        class="link"
        title={board.mazes[maze].name}
        act={() => open(a, b, maze)}
      />
    ),
    best,
    class: 'first',
  };
  const difference = {
    title: 'difference',
    meaning: `The first minus the second, in ${unit}: below zero, the first is better.`,
    value: (pair: Pair) => pair.difference,
    show: (pair: Pair) => signed(pair.difference, 3),
    best,
  };
  return (
    <SortedTable
      caption={`Mean scores in ${unit}; choose a maze to open both contests.`}
      heard
      columns={[maze, difference, scoreColumn(a, (pair) => pair.a), scoreColumn(b, (pair) => pair.b)]}
      rows={pairs}
      by={1}
    />
  );
}

/** The differences as bars, with what the pointer is at. */
function BarChart({ board, compared, open }: Props & { compared: Compared | null }) {
  const [box, canvas] = [useRef<HTMLDivElement>(null), useRef<HTMLCanvasElement>(null)];
  const bars = useRef<Bars | null>(null);
  const [pointed, point] = useState<{ pair: Pair; of: Compared } | null>(null);
  const name = (mouse: number) => board.mice[mouse].shown;
  const { a, b, pairs, found } = compared ?? { a: 0, b: 0, pairs: [], found: null };
  const [first, second] = [name(a), name(b)];
  function paint() {
    const width = box.current!.clientWidth;
    if (width > 0) bars.current = paintBars(canvas.current!, pairs, found, paperWidth() ?? width);
  }
  usePainted(box, paint, [compared]);
  const pairAt = ({ offsetX }: MouseEvent) => bars.current?.at(offsetX) ?? null;
  const read = (event: MouseEvent) => {
    const pair = pairAt(event);
    if (pair && compared) point({ pair, of: compared });
  };
  const click = (event: MouseEvent) => {
    const pair = pairAt(event);
    if (pair) open(a, b, pair.maze);
  };
  const says = ({ maze, a, b, difference }: Pair) =>
    `${board.mazes[maze].short}: ${first} ${scoreText(a)}, ${second} ${scoreText(b)}, difference ${signed(difference, 3)}`;
  const about = `One bar for each maze: score of ${first} minus score of ${second}, in ${board.shows.unit}. Below zero, ${first} is better. Line and band: the mean and its 95 % interval.`;
  return (
    <>
      <div class="bars" hidden={!found} ref={box}>
        <canvas
          role="img"
          aria-label={`Differences in score, ${first} minus ${second}, one bar for each maze, sorted. The table below has the same numbers.`}
          ref={canvas}
          onPointerMove={read}
          onClick={click}
        />
      </div>
      <p class="caption">{compared && (pointed?.of === compared ? says(pointed.pair) : about)}</p>
    </>
  );
}

export function Duel({ page, board, open }: Props & { page: EarlyPage }) {
  const [[a, b], choose] = useState([0, Math.min(1, board.mice.length - 1)]);
  const [shown, show] = useState<Compared | null>(null);
  const [failed, fail] = useState('');
  useEffect(() => {
    // What comes late, for a pair that is no longer chosen, is dropped.
    let wanted = true;
    compared(page, board, a, b).then(
      (found) => {
        if (!wanted) return;
        found.pairs.sort((one, other) => one.difference - other.difference);
        fail('');
        show(found);
      },
      (error) => wanted && fail(errorText(error)),
    );
    return () => void (wanted = false);
  }, [board, a, b]);
  const mice = board.mice.map(({ shown, index }) => [index, shown]);
  return (
    <div>
      <div class="row controls">
        <label class="row">
          First
          <Select options={mice} value={a} choose={(mouse) => choose([Number(mouse), b])} />
        </label>
        <label class="row">
          second
          <Select options={mice} value={b} choose={(mouse) => choose([a, Number(mouse)])} />
        </label>
      </div>
      <p class="words" aria-live="polite">
        {failed || shown?.words}
      </p>
      <BarChart board={board} compared={shown} open={open} />
      <Scrolling label="Differences, maze by maze" class="box tall" hidden={!shown?.found}>
        {shown && <PairTable key={shown} board={board} compared={shown} open={open} />}
      </Scrolling>
    </div>
  );
}
