// Two mice against each other, maze by maze.
import type { PairedDifference } from '../core/types';
import { h } from '../ui/dom';
import { paperWidth } from '../ui/tones';
import type { EarlyPage } from '../page/page';
import type { Board } from '../results/contests';
import { paintBars, type Bars } from './duel-bars';
import { failureDifferences, pairsOf, type Pair } from './duel-data';
import { duelWords, failureWords } from './duel-words';
import { number, scoreText, signed } from '../ui/format';
import { sortedTable } from './sorted-table';
import { isHome } from '../results/worlds';

export interface Duel {
  element: HTMLElement;
  arrange(): void;
}

/** `open` shows both contests beside each other. */
export function duel(page: EarlyPage, board: Board, open: (a: number, b: number, maze: number) => void): Duel {
  let [a, b] = [0, Math.min(1, board.mice.length - 1)];
  let pairs: Pair[] = [];
  let found: PairedDifference | null = null;
  let bars: Bars | null = null;
  // What comes late, for a pair that is no longer chosen, is dropped.
  let asked = 0;

  const canvas = h('canvas', { role: 'img' });
  const words = h('p', { class: 'words', 'aria-live': 'polite' });
  const caption = h('p', { class: 'caption' });
  const tableBox = h('div', {
    class: 'box tall',
    tabindex: 0,
    role: 'region',
    'aria-label': 'Differences, maze by maze',
  });
  const picture = h('div', { class: 'bars' }, canvas);

  const name = (mouse: number) => board.mice[mouse].shown;
  const { unit, limit, countsFailures } = board.shows;
  const mazeName = (maze: number) => board.mazes[maze].short;
  const pairText = (pair: Pair) =>
    `${mazeName(pair.maze)}: ${name(a)} ${scoreText(pair.a)}, ${name(b)} ${scoreText(pair.b)}, difference ${signed(pair.difference, 3)}`;

  const scoreColumn = (mouse: number, value: (pair: Pair) => number) => ({
    title: board.mice[mouse].short,
    meaning: `Mean score of ${board.mice[mouse].name} in this maze, in ${unit}.`,
    value,
    show: (pair: Pair) => number(value(pair), 3),
    best: 'ascending' as const,
  });
  function table() {
    const columns = [
      {
        title: 'maze',
        meaning: 'Opens both contests side by side.',
        value: ({ maze }: Pair) => mazeName(maze),
        show: ({ maze }: Pair) =>
          h(
            'button',
            { type: 'button', class: 'link', title: board.mazes[maze].name, onclick: () => open(a, b, maze) },
            mazeName(maze),
          ),
        best: 'ascending' as const,
        class: 'first',
      },
      {
        title: 'difference',
        meaning: `The first minus the second, in ${unit}: below zero, the first is better.`,
        value: (pair: Pair) => pair.difference,
        show: (pair: Pair) => signed(pair.difference, 3),
        best: 'ascending' as const,
      },
      scoreColumn(a, (pair) => pair.a),
      scoreColumn(b, (pair) => pair.b),
    ];
    return sortedTable({
      caption: `Mean scores in ${unit}; choose a maze to open both contests.`,
      columns,
      rows: pairs,
      by: 1,
    }).element;
  }
  function arrange() {
    if (picture.clientWidth > 0) bars = paintBars(canvas, pairs, found, paperWidth() ?? picture.clientWidth);
  }
  async function choose() {
    const now = ++asked;
    const { rules } = await page.ready;
    const fresh = pairsOf(board, a, b, isHome(board) ? rules.failure_score : limit);
    // In the order of the mazes, as the command line does: the bootstrap draws by position.
    const seed = page.race()?.results.seed;
    const compare = (differences: number[]) =>
      page.core.call('compare', { differences, ...(Number.isSafeInteger(seed) && { seed }) });
    const answer = fresh.length > 0 ? await compare(fresh.map(({ difference }) => difference)) : null;
    const failed =
      answer && !countsFailures && limit !== null ? await compare(failureDifferences(board, a, b, fresh)) : null;
    if (now !== asked) return;
    pairs = fresh.sort((one, other) => one.difference - other.difference);
    found = answer;
    words.textContent = found
      ? duelWords(name(a), name(b), found, unit) + (failed ? failureWords(failed, limit ?? 0, unit) : '')
      : 'These two did not race in the same mazes.';
    for (const piece of [picture, tableBox]) piece.hidden = !found;
    canvas.setAttribute(
      'aria-label',
      `Differences in score, ${name(a)} minus ${name(b)}, one bar for each maze, sorted. The table below has the same numbers.`,
    );
    caption.textContent = `One bar for each maze: score of ${name(a)} minus score of ${name(b)}, in ${unit}. Below zero, ${name(a)} is better. Line and band: the mean and its 95 % interval.`;
    tableBox.replaceChildren(table());
    arrange();
  }
  const tryToChoose = () =>
    void choose().catch((error) => (words.textContent = error instanceof Error ? error.message : String(error)));

  canvas.addEventListener('pointermove', (event) => {
    const pair = bars?.at(event.offsetX);
    if (pair) caption.textContent = pairText(pair);
  });
  canvas.addEventListener('click', (event) => {
    const pair = bars?.at(event.offsetX);
    if (pair) open(a, b, pair.maze);
  });
  const chooser = (chosen: number, set: (mouse: number) => void) => {
    const select = h(
      'select',
      { onchange: () => (set(Number(select.value)), tryToChoose()) },
      ...board.mice.map(({ shown: label, index }) => h('option', { value: index, selected: index === chosen }, label)),
    );
    return select;
  };
  for (const piece of [picture, tableBox]) piece.hidden = true;
  const element = h(
    'div',
    {},
    h(
      'div',
      { class: 'row controls' },
      h(
        'label',
        { class: 'row' },
        'First',
        chooser(a, (mouse) => (a = mouse)),
      ),
      h(
        'label',
        { class: 'row' },
        'second',
        chooser(b, (mouse) => (b = mouse)),
      ),
    ),
    words,
    picture,
    caption,
    tableBox,
  );
  tryToChoose();
  return { element, arrange };
}
