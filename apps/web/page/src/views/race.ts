// The view of a race: who is best, where, by how much, and each contest a click away from its replay.
import { contestPlay } from '../race/contest-play';
import { addressOf, readAddress } from '../link/address';
import { orderIn, orderMoment, isQuick } from '../race/linked-order';
import { boardOf, groupsOf, type Board } from '../race/contests';
import { curves } from '../race/curves';
import { duel } from '../race/duel';
import { heat } from '../race/heat';
import { holdPanel, type HoldPanel } from '../race/hold-panel';
import { leaderboard } from '../race/leaderboard';
import { matrix } from '../race/matrix';
import { facts, part } from '../race/parts';
import { welcome } from '../race/welcome';
import { h } from '../ui/dom';
import { onTones } from '../ui/tones';
import type { EarlyPage, LoadedRace, View } from './view';
import '../styles/race.css';

/** What can be drawn again for the room and the tones that there are now. */
interface Part {
  arrange(): void;
}

/** Once the next frame has been painted; at once where nothing is painted. */
function afterFrame(act: () => void) {
  if (document.hidden) setTimeout(act);
  else requestAnimationFrame(() => setTimeout(act));
}

export function createRace(page: EarlyPage): View {
  const element = h('section', { 'aria-label': 'Race', class: 'race' });
  let shownRace: LoadedRace | null | undefined;
  let parts: Part[] = [];
  let panel: Promise<HoldPanel> | null = null;

  function replayContests(race: LoadedRace, board: Board, at: { mouse: number; maze: number; position: number }[]) {
    page.tell('Opening the replay …');
    Promise.all(at.map((one) => contestPlay(page, race, board, one)))
      .then((plays) => {
        page.tell([...new Set(plays.map(({ remark }) => remark).filter(Boolean))].join(' '));
        page.replay(plays.map(({ play, record }) => ({ play, record })));
      })
      .catch((error) => {
        page.tell('');
        page.complain(error);
      });
  }

  /** The pictures of one world, and what orders and filters their mice. */
  function boardParts(race: LoadedRace, board: Board) {
    const cells = matrix(board, (mouse, maze, position) => replayContests(race, board, [{ mouse, maze, position }]));
    const lines = curves(board);
    const pair =
      board.mice.length > 1
        ? duel(page, board, (a, b, maze) =>
            replayContests(
              race,
              board,
              [a, b].map((mouse) => ({ mouse, maze, position: 0 })),
            ),
          )
        : null;
    // In seconds what a move loses depends on speed and heading, too: it is no matter of cells.
    const lost = board.shows.losesCells ? heat(page, race, board) : null;
    parts.push(cells, lines, ...(pair ? [pair] : []), ...(lost ? [lost] : []));
    const { title: world, bestMeaning: best } = board.shows;
    return {
      board,
      cells,
      elements: [
        part(
          `Mice × mazes${world}`,
          'How close each mouse came to the best possible score. Choose a cell to open its replay.',
          cells.element,
        ),
        part(
          `Distributions${world}`,
          `How many contests of a mouse score within a given ratio of the ${best}. Further up and to the left is better.`,
          lines.element,
        ),
        ...(pair ? [part(`Two mice${world}`, '', pair.element)] : []),
        ...(lost
          ? [
              part(
                'Where steps are lost',
                'What the contests of a maze cost beyond the best possible score, by the cell in which it was lost. A step loses what it leaves the mouse behind a shortest way; after the goal, every step of the exploration counts.',
                lost.element,
              ),
            ]
          : []),
      ],
    };
  }

  /** The tables at once, the pictures after the next frame: they take longer, and need the contests sorted. */
  function shownRaceParts(race: LoadedRace): HTMLElement[] {
    const { results } = race;
    const groups = groupsOf(results);
    let boards: ReturnType<typeof boardParts>[] = [];
    /** The positions of the mice of each group. */
    const orders = new Map<number, number[]>();
    const arrangeRows = () => orders.forEach((order, group) => boards[group]?.cells.order(order));
    const tables = groups.map((group, index) =>
      leaderboard(group, (order) => {
        orders.set(index, order);
        arrangeRows();
      }),
    );
    const search = h('input', { type: 'search', placeholder: 'Search mice', 'aria-label': 'Search mice by name' });
    search.addEventListener('input', () =>
      [...tables, ...boards.map(({ cells }) => cells)].forEach((one) => one.filter(search.value)),
    );
    const save = h(
      'button',
      { type: 'button', onclick: () => page.save('results.json', `${JSON.stringify(results)}\n`, 'application/json') },
      'Save results',
    );
    const goBack = page.backToReport();
    const back = goBack && h('button', { type: 'button', onclick: goBack }, 'Back to the report');
    const pictures = h('div', { class: 'race pictures' });
    afterFrame(() => {
      if (race !== shownRace) return;
      boards = groups.map((group) => boardParts(race, boardOf(group)));
      pictures.append(...boards.flatMap(({ elements }) => elements));
      arrangeRows();
      arrange();
    });
    return [
      h('p', { class: 'note facts' }, facts(results)),
      part(
        'Leaderboard',
        '',
        h('div', { class: 'row controls' }, search, save, back),
        ...tables.map((table) => table.element),
      ),
      pictures,
    ];
  }

  function holdPart(first: boolean) {
    const room = h('div', {}, h('p', { class: 'note' }, 'Starting …'));
    panel = page.ready.then((about) => holdPanel(page, about, first));
    panel.then(
      (made) => room.replaceChildren(made.element),
      () =>
        room.replaceChildren(h('p', { class: 'note' }, 'This page cannot run races, because its core did not start.')),
    );
    const about = h(
      'p',
      { class: 'note' },
      'Choose mice and mazes to race in this page. To see results from the command line, write them with ',
      h('code', {}, 'labmouse race --format json > results.json'),
      ' and drop the file anywhere on this page. ',
      h('code', {}, 'labmouse report results.json -o report.html'),
      ' makes a separate page from them, with the replays.',
    );
    return first
      ? part('Run a race', '', about, room)
      : h('details', { class: 'part controls' }, h('summary', {}, 'Run another race'), about, room);
  }

  function render(race: LoadedRace | null) {
    parts = [];
    element.replaceChildren(
      h('h2', { class: 'unseen' }, 'Race'),
      ...(race ? shownRaceParts(race) : [welcome(page)]),
      holdPart(!race),
    );
  }
  const arrange = () => !element.hidden && parts.forEach((one) => one.arrange());
  onTones(arrange);
  let width = 0;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    arrange();
  }).observe(element);

  return {
    element,
    shown() {
      const race = page.race();
      if (race !== shownRace) {
        shownRace = race;
        try {
          render(race);
        } catch (error) {
          render(null);
          page.complain(`These results cannot be shown: ${error instanceof Error ? error.message : String(error)}`);
        }
      }
      void panel?.then(
        (made) => made.refresh(),
        () => undefined,
      );
      arrange();
    },
    async address() {
      const about = await page.ready;
      const form = await panel!;
      const order = shownRace?.order ?? form.order();
      if (shownRace && !shownRace.order)
        throw new Error('These results came from a file: send the file. A link holds races of mice that the page has.');
      return addressOf('race', await orderMoment(page.core, about, order));
    },
    async follow(hash) {
      const about = await page.ready;
      const form = await panel!;
      const order = await orderIn(page.core, about, readAddress(hash).moment);
      form.set(order);
      const folded = form.element.closest('details');
      if (folded) folded.open = true;
      if (isQuick(about, order)) return form.start();
      form.element.scrollIntoView({ block: 'nearest' });
      page.tell('The race of this link is set up: start it when you like.');
    },
  };
}
