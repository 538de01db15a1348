// Two mice against each other, maze by maze.
import type { PairedDifference } from '../core/types';
import { button, select } from '../ui/controls';
import { h } from '../ui/dom';
import { paperWidth } from '../ui/tones';
import type { EarlyPage } from '../page/page';
import type { Board } from '../results/contests';
import { paintBars, type Bars } from './duel-bars';
import { failureDifferences, pairsOf, type Pair } from './duel-data';
import { duelWords, failureWords } from './duel-words';
import { errorText, number, scoreText, signed } from '../ui/format';
import { sortedTable } from '../ui/sorted-table';

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

type Open = (a: number, b: number, maze: number) => void;

/** The differences as a table, a line for each maze. */
function pairTable(board: Board, { a, b, pairs }: Compared, open: Open) {
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
    show: ({ maze }: Pair) =>
      button(board.mazes[maze].short, () => open(a, b, maze), { class: 'link', title: board.mazes[maze].name }),
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
  return sortedTable({
    caption: `Mean scores in ${unit}; choose a maze to open both contests.`,
    columns: [maze, difference, scoreColumn(a, (pair) => pair.a), scoreColumn(b, (pair) => pair.b)],
    rows: pairs,
    by: 1,
  }).element;
}

/** The differences as bars, with what the pointer is at. */
function createBars(board: Board, open: Open) {
  const canvas = h('canvas', { role: 'img' });
  const caption = h('p.caption');
  const element = h('div.bars', { hidden: true }, canvas);
  const { unit } = board.shows;
  const name = (mouse: number) => board.mice[mouse].shown;
  let shown: Compared | null = null;
  let bars: Bars | null = null;
  const atPair = (act: (pair: Pair, shown: Compared) => void) => (event: MouseEvent) => {
    const pair = bars?.at(event.offsetX);
    if (pair && shown) act(pair, shown);
  };
  const say = (pair: Pair, { a, b }: Compared) => {
    const scores = `${name(a)} ${scoreText(pair.a)}, ${name(b)} ${scoreText(pair.b)}`;
    caption.textContent = `${board.mazes[pair.maze].short}: ${scores}, difference ${signed(pair.difference, 3)}`;
  };
  canvas.addEventListener('pointermove', atPair(say));
  canvas.addEventListener(
    'click',
    atPair(({ maze }, { a, b }) => open(a, b, maze)),
  );
  function arrange() {
    const width = element.clientWidth;
    if (width > 0) bars = paintBars(canvas, shown?.pairs ?? [], shown?.found ?? null, paperWidth() ?? width);
  }
  return {
    element,
    caption,
    arrange,
    show(now: Compared) {
      shown = now;
      const [first, second] = [name(now.a), name(now.b)];
      const label = `Differences in score, ${first} minus ${second}, one bar for each maze, sorted. The table below has the same numbers.`;
      element.hidden = !now.found;
      canvas.setAttribute('aria-label', label);
      caption.textContent = `One bar for each maze: score of ${first} minus score of ${second}, in ${unit}. Below zero, ${first} is better. Line and band: the mean and its 95 % interval.`;
      arrange();
    },
  };
}

/** `open` shows both contests beside each other. */
export function duel(page: EarlyPage, board: Board, open: Open) {
  // What comes late, for a pair that is no longer chosen, is dropped.
  let asked = 0;
  const words = h('p.words', { 'aria-live': 'polite' });
  const bars = createBars(board, open);
  const tableBox = h('div.box.tall', {
    tabindex: 0,
    role: 'region',
    'aria-label': 'Differences, maze by maze',
    hidden: true,
  });
  const mice = board.mice.map(({ shown, index }): [number, string] => [index, shown]);
  const choices = [0, Math.min(1, board.mice.length - 1)].map((chosen) => {
    const choice = select(mice, tryToChoose);
    choice.value = String(chosen);
    return choice;
  });
  async function choose() {
    const now = ++asked;
    const [a, b] = choices.map(({ value }) => Number(value));
    const found = await compared(page, board, a, b);
    if (now !== asked) return;
    found.pairs.sort((one, other) => one.difference - other.difference);
    words.textContent = found.words;
    tableBox.hidden = !found.found;
    tableBox.replaceChildren(pairTable(board, found, open));
    bars.show(found);
  }
  function tryToChoose() {
    choose().catch((error) => (words.textContent = errorText(error)));
  }
  const labels = ['First', 'second'].map((label, i) => h('label.row', label, choices[i]));
  const row = h('div.row.controls', ...labels);
  tryToChoose();
  return { element: h('div', row, words, bars.element, bars.caption, tableBox), arrange: bars.arrange };
}
