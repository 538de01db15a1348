// The tables and pictures of a race.
import type { EarlyPage } from '../page/page';
import { boardOf, groupsOf, type Board } from '../results/contests';
import type { LoadedRace } from '../results/loaded';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import { replayContests } from './contest-play';
import { curves } from './curves';
import { duel } from './duel';
import { heat } from './heat';
import { leaderboard } from './leaderboard';
import { matrix, type Matrix } from './matrix';
import { errorCurves } from './error-curves';
import { errorCurvesPicture } from './error-curves-picture';
import { facts, part } from './parts';

/** What can be drawn again for the room and the tones that there are now. */
export interface Painted {
  arrange(): void;
}

interface BoardParts {
  board: Board;
  cells: Matrix;
  painted: Painted[];
  elements: HTMLElement[];
}

/** Where steps are lost: in seconds that depends on speed and heading, too, and is no matter of cells. */
function lossPart(page: EarlyPage, race: LoadedRace, board: Board): { painted: Painted[]; element: HTMLElement } {
  const { title, inSteps } = board.shows;
  const elsewhere =
    'This map is drawn of races in steps. Elsewhere a move costs what its speed and heading make of it, so that no cell alone can be blamed: choose a contest above, and compare two mice on one clock.';
  if (!inSteps) return { painted: [], element: part(`Where steps are lost${title}`, elsewhere) };
  const lost = heat(page, race, board);
  const about =
    'What the contests of a maze cost beyond the best possible score, by the cell in which it was lost. A step loses what it leaves the mouse behind a shortest way; after the goal, every step of the search run counts.';
  return { painted: [lost], element: part('Where steps are lost', about, lost.element) };
}

/** The pictures of one world, and what orders and filters their mice. */
function boardParts(page: EarlyPage, race: LoadedRace, board: Board): BoardParts {
  const { title, bestMeaning } = board.shows;
  const replay = replayContests(page, race, board);
  const cells = matrix(board, (mouse, maze, position) => replay([{ mouse, maze, position }]));
  const lines = curves(board);
  const both = (a: number, b: number, maze: number) => replay([a, b].map((mouse) => ({ mouse, maze, position: 0 })));
  const pairs = board.mice.length > 1 ? [duel(page, board, both)] : [];
  const lost = lossPart(page, race, board);
  const closeness = 'How close each mouse came to the best possible score. Choose a cell to open its replay.';
  const within = `How many contests of a mouse score within a given ratio of the ${bestMeaning}. Further up and to the left is better.`;
  return {
    board,
    cells,
    painted: [cells, lines, ...pairs, ...lost.painted],
    elements: [
      part(`Mice × mazes${title}`, closeness, cells.element),
      part(`Distributions${title}`, within, lines.element),
      ...pairs.map(({ element }) => part(`Two mice${title}`, '', element)),
      lost.element,
    ],
  };
}

/** Once the next frame has been painted; at once where nothing is painted. */
function afterFrame(act: () => void) {
  if (document.hidden) setTimeout(act);
  else requestAnimationFrame(() => setTimeout(act));
}

/**
 * The tables at once, the pictures after the next frame: they take longer, and need the contests sorted. `drawn` hears of
 * them, unless the race is not `wanted` any more.
 */
export function raceParts(
  page: EarlyPage,
  race: LoadedRace,
  isExample: boolean,
  wanted: () => boolean,
  drawn: (painted: Painted[], first: Board) => void,
): { tables: HTMLElement[]; pictures: HTMLElement } {
  const { results } = race;
  const groups = groupsOf(results);
  let boards: BoardParts[] = [];
  /** The positions of the mice of each group. */
  const orders = new Map<number, number[]>();
  const arrangeRows = () => orders.forEach((order, group) => boards[group]?.cells.order(order));
  const tables = groups.map((group, index) =>
    leaderboard(
      group,
      (order) => {
        orders.set(index, order);
        arrangeRows();
      },
      [],
      groups,
    ),
  );
  const search = h('input', { type: 'search', placeholder: 'Search mice', 'aria-label': 'Search mice by name' });
  search.addEventListener('input', () =>
    [...tables, ...boards.map(({ cells }) => cells)].forEach((one) => one.filter(search.value)),
  );
  const save = () => page.save('results.json', `${JSON.stringify(results)}\n`, 'application/json');
  const goBack = page.backToReport();
  const controls = [search, button('Save results', save), goBack && button('Back to the report', goBack)];
  const pictures = h('div.race.pictures');
  afterFrame(() => {
    if (!wanted()) return;
    boards = groups.map((group) => boardParts(page, race, boardOf(group, groups)));
    const curves = errorCurves(groups);
    const curvePictures = curves ? [{ ...errorCurvesPicture(curves), title: `As ${curves.scaled} grows` }] : [];
    const finished = 'The share of contests that each mouse finished.';
    pictures.append(
      ...curvePictures.map(({ element, title }) => part(title, finished, element)),
      ...boards.flatMap(({ elements }) => elements),
    );
    arrangeRows();
    drawn([...boards.flatMap(({ painted }) => painted), ...curvePictures], boards[0].board);
  });
  const line = isExample ? `An example: ${facts(results)}` : facts(results);
  const board = h('div.row.controls', ...controls);
  return {
    tables: [h('p.note.facts', line), part('Leaderboard', '', board, ...tables.map(({ element }) => element))],
    pictures,
  };
}
