import type { MazeData, Mouse } from '../core/types';
import { addressOf, readAddress } from '../link/address';
import { driveOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import { createBench } from '../live/bench';
import { createEveryone } from '../live/everyone';
import { createMazeChoice } from '../choice/maze-choice';
import { createWorldChoice } from '../choice/world-choice';
import { createMouseChoice } from '../choice/mouse-choice';
import { withoutRemarks } from '../link/my-robot';
import { h } from '../ui/dom';
import { complainAt, field } from '../ui/field';
import { createLatest } from '../ui/latest';
import type { Page, View } from '../page/page';
import '../styles/forms.css';
import '../styles/live.css';

/** Live, and the maze that is chosen there. */
export interface LiveView extends View {
  maze(): MazeData | null;
}

/** Runs like any mouse, but knows the maze. */
const oracle: Mouse = {
  name: 'oracle',
  summary: 'knows the maze: a reference, not a contestant',
  throws_dice: false,
  parameters: [],
};

const isMaze = (thing: unknown): thing is MazeData =>
  typeof thing === 'object' && thing !== null && Array.isArray((thing as MazeData).walls);

/** The view Live: one mouse in one maze, run at once. It accepts mazes. */
export function createLive(page: Page): LiveView {
  const { rules } = page.about;
  const mice = page.about.mice.filter(({ walks }) => walks !== false);
  let maze: MazeData | null = null;
  let written = '';
  let isShown = false;
  type Chosen = NonNullable<ReturnType<typeof order>>;

  const mouse = createMouseChoice(mice.some(({ name }) => name === oracle.name) ? mice : [...mice, oracle], changed);
  const mazes = createMazeChoice(page, (next) => {
    maze = next;
    everyone.clear();
    changed();
  });
  const seed = h('input', { type: 'number', min: 0, step: 1, value: 1, oninput: () => (everyone.clear(), changed()) });
  const budget = h('input', { type: 'number', min: 1, step: 1, value: rules.budget });
  budget.addEventListener('input', () => (everyone.clear(), changed()));
  const budgetRow = field('Budget', budget, h('span', {}, `limit for both runs together; ${rules.budget} in contests`));
  const seedRow = field('Seed', seed);
  const single = page.about.worlds.filter(({ call }) => call === 'run' || call === 'drive');
  const world = createWorldChoice(page.about, () => (showWorld(), changed()), single);
  const bench = createBench(page, (message) => {
    complainAt({ seed: seedRow, budget: budgetRow, mouse }, 'mouse', message);
    if (message) showComplaint();
  });
  const everyone = createEveryone(page, order, (spec, itsSeed) => {
    mouse.choose(spec);
    seed.value = String(itsSeed);
    changed();
    scrollTo({ top: 0, behavior: 'instant' });
  });

  function showWorld() {
    budgetRow.hidden = everyone.button.hidden = world.drive() !== null;
    if (world.drive()) everyone.clear();
    mouse.playIn(world.drive() ? 'seconds' : 'steps');
  }
  function showComplaint() {
    const row = side.querySelector('[aria-invalid]')?.closest('.field');
    const closed = row?.closest('details');
    if (closed) closed.open = true;
    row?.scrollIntoView({ block: 'nearest' });
  }
  function order() {
    // What is empty is no number, and no 0: the core says so.
    const numbers = { seed: seed.valueAsNumber, budget: budget.valueAsNumber };
    return maze && { spec: mouse.spec(), maze, ...numbers, drive: world.drive() };
  }
  function changed() {
    const now = order();
    if (!now || !isShown) return;
    bench.run(now);
    if (Number.isFinite(now.seed) && (now.drive || Number.isFinite(now.budget))) address.ask(now);
  }
  /** The address says what is shown, so that a reload or a shared link shows the same. */
  const address = createLatest(
    (now: Chosen) => addressFor(now),
    (text) => {
      written = `#${text}`;
      void page.shelf.write('live', written);
      if (isShown) history.replaceState(null, '', written);
    },
    () => undefined,
    300,
  );
  async function addressFor({ spec, maze, seed, budget, drive }: Chosen, moment = {}) {
    const place = await placeOf(page.core, page.about, maze);
    const steps = drive || budget === rules.budget ? {} : { budget };
    const driven = drive && { ...drive, robot: withoutRemarks(drive.robot) };
    return addressOf('live', { mice: [spec], ...place, seeds: [seed], ...steps, ...driven, ...moment });
  }
  async function follow(hash: string) {
    if (hash === written) return;
    const { moment } = readAddress(hash);
    if (moment.mice.length > 1 || moment.seeds.length > 1)
      throw new Error('This link cannot be followed: Live runs one mouse from one seed.');
    const drive = driveOf(moment, page.about);
    if (moment.mice.length > 0) mouse.choose(moment.mice[0]);
    if (moment.seeds.length > 0) seed.value = String(moment.seeds[0]);
    if (moment.budget !== undefined) budget.value = String(moment.budget);
    if (drive || moment.mice.length > 0) (world.choose(drive?.world, drive?.with), showWorld());
    if (moment.time !== undefined || moment.look) bench.begin(moment);
    const linked = await mazeAt(page.core, moment);
    written = hash;
    if (linked && moment.builtin.length > 0) mazes.choose(moment.builtin[0]);
    else if (linked) mazes.give(linked);
    else if (maze && !mazes.isDrawing()) changed();
    else mazes.refresh();
  }

  const side = h(
    'div',
    { class: 'desk-side' },
    mouse.element,
    mazes.element,
    mouse.parameters,
    h(
      'section',
      { class: 'card', 'aria-label': 'Contest' },
      h('h2', {}, 'Contest'),
      world.element,
      h('div', { class: 'field-row' }, seedRow, budgetRow),
      everyone.button,
    ),
  );
  return {
    element: h(
      'section',
      { 'aria-label': 'Live', class: 'live' },
      h('div', { class: 'desk' }, side, h('div', { class: 'desk-main' }, bench.element, everyone.element)),
    ),
    maze: () => maze,
    shown() {
      isShown = true;
      if (maze && !mazes.isDrawing()) changed();
      else mazes.refresh();
    },
    follow,
    async address() {
      const now = order();
      if (!now || !Number.isSafeInteger(now.seed) || !Number.isSafeInteger(now.budget)) return 'live';
      return addressFor(now, bench.moment());
    },
    hidden() {
      isShown = false;
      bench.stop();
    },
    accept(thing) {
      if (!isMaze(thing)) return;
      mazes.give(thing);
      // What stands in the address is older than this.
      written = location.hash;
    },
  };
}
