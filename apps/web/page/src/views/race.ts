// The view of a race: who is best, where, by how much, and each contest a click away from its replay.
import { contestPlay } from '../race/contest-play';
import { createPlayer } from '../player/player';
import { addressOf, readAddress } from '../link/address';
import { orderIn, orderMoment, isQuick } from '../race/linked-order';
import { boardOf, groupsOf, type Board } from '../results/contests';
import { worldOf } from '../results/worlds';
import { curves } from '../race/curves';
import { duel } from '../race/duel';
import { exampleRace } from '../results/example';
import { scoreText } from '../ui/format';
import { heat } from '../race/heat';
import { holdPanel, type HoldPanel } from '../race/hold-panel';
import { leaderboard } from '../race/leaderboard';
import { matrix } from '../race/matrix';
import { noisePicture } from '../race/noise';
import { noiseCurves } from '../race/noise-data';
import { facts, part } from '../race/parts';
import { h } from '../ui/dom';
import { onTones } from '../ui/tones';
import type { EarlyPage, View } from '../page/page';
import type { LoadedRace } from '../results/loaded';
import '../styles/forms.css';
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
  const element = h('section', { 'aria-label': 'Race', class: 'race-view' });
  const player = createPlayer(page);
  const stage = h('div', { class: 'bench' }, player.element);
  const onStage = h('p', { class: 'unseen on-stage', role: 'status' });
  let shownRace: LoadedRace | null | undefined;
  let parts: Part[] = [];
  let panel: Promise<HoldPanel> | null = null;
  /** What stands here until there is a race: null before it was held. */
  let example: LoadedRace | null = null;
  /** Whether one is being held. */
  let holding = false;
  /** The form as it is before there is a race, with what is chosen in it. */
  let firstForm: HTMLElement | null = null;

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
          : [
              part(
                `Where steps are lost${world}`,
                'This map is drawn of races in steps. Elsewhere a move costs what its speed and heading make of it, so that no cell alone can be blamed: choose a contest above, and compare two mice on one clock.',
              ),
            ]),
      ],
    };
  }

  /**
   * Whether one of its contests can be put on a stage: what came in a file may be large, and be of mice that the page cannot
   * run, and there are worlds in which it runs none again.
   */
  function hasStage({ order, results }: LoadedRace) {
    const [group] = groupsOf(results);
    return order !== undefined && group !== undefined && worldOf(group).again !== undefined;
  }

  /** The best mouse in the first maze, on the stage. */
  function perform(race: LoadedRace, board: Board) {
    contestPlay(page, race, board, { mouse: 0, maze: 0, position: 0 })
      .then((one) => {
        if (race !== shownRace) return;
        player.show([one], 'end');
        const { mouse, maze, score } = one.play;
        onStage.replaceChildren(`On the stage: ${mouse} in ${maze.name}, score ${scoreText(score)}.`);
      })
      .catch(page.complain);
  }

  /** The tables at once, the pictures after the next frame: they take longer, and need the contests sorted. */
  function shownRaceParts(race: LoadedRace): { tables: HTMLElement[]; pictures: HTMLElement } {
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
      const noisy = noiseCurves(groups);
      if (noisy) {
        const picture = noisePicture(noisy);
        parts.push(picture);
        pictures.append(part('As noise grows', 'The share of contests that each mouse finished.', picture.element));
      }
      pictures.append(...boards.flatMap(({ elements }) => elements));
      arrangeRows();
      arrange();
      if (hasStage(race)) perform(race, boards[0].board);
    });
    return {
      tables: [
        h('p', { class: 'note facts' }, race === example ? `An example: ${facts(results)}` : facts(results)),
        part(
          'Leaderboard',
          '',
          h('div', { class: 'row controls' }, search, save, back),
          ...tables.map((table) => table.element),
        ),
      ],
      pictures,
    };
  }

  function holdPart(first: boolean) {
    const room = h('div', {}, h('p', { class: 'note' }, 'Starting …'));
    panel = page.ready.then((about) => holdPanel(page, about));
    panel.then(
      (made) => room.replaceChildren(made.element),
      () =>
        room.replaceChildren(h('p', { class: 'note' }, 'This page cannot run races, because its core did not start.')),
    );
    const about = h(
      'details',
      { class: 'note' },
      h('summary', {}, 'Or show results from the command line'),
      h(
        'p',
        {},
        'Write them with ',
        h('code', {}, 'labmouse race --format json > results.json'),
        ' and drop the file anywhere on this page. ',
        h('code', {}, 'labmouse report results.json -o report.html'),
        ' makes a separate page from them, with the replays.',
      ),
    );
    return first
      ? part('Run a race', 'Choose mice and mazes: the race is held in this page.', room, about)
      : h('details', { class: 'part controls' }, h('summary', {}, 'Run another race'), room, about);
  }

  function render(race: LoadedRace | null) {
    parts = [];
    player.show([]);
    onStage.replaceChildren();
    const title = h('h2', { class: 'unseen' }, 'Race');
    const isFirst = race === null || race === example;
    const hold = isFirst ? (firstForm ??= holdPart(true)) : holdPart(false);
    if (!isFirst) firstForm = null;
    if (!race)
      return element.replaceChildren(
        title,
        h('div', { class: 'race-stage' }, h('div', { class: 'race' }, hold), stage),
      );
    const { tables, pictures } = shownRaceParts(race);
    if (!hasStage(race)) return element.replaceChildren(title, h('div', { class: 'race' }, ...tables, pictures, hold));
    element.replaceChildren(
      title,
      h(
        'div',
        { class: 'race-stage' },
        h('div', { class: 'race' }, ...(isFirst ? [hold] : []), onStage, ...tables),
        stage,
      ),
      h('div', { class: 'race' }, pictures, ...(isFirst ? [] : [hold])),
    );
  }
  /** Whether the example is still what should stand here. */
  const lacksRace = () => page.race() === null && !element.hidden;
  async function hold() {
    if (holding || example) return;
    holding = true;
    // What keeps the core from starting is said by the page itself.
    const held = await exampleRace(page, lacksRace).catch(() => null);
    holding = false;
    if (!held || !lacksRace()) return;
    shownRace = example = held;
    render(held);
    arrange();
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
      const race = page.race() ?? example;
      // What a link asks for is on its way.
      if (!race && !location.hash.startsWith('#race&')) void hold();
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
    hidden: () => player.stop(),
    async address() {
      const about = await page.ready;
      const form = await panel!;
      const race = page.race();
      const order = race?.order ?? form.order();
      if (race && !race.order)
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
