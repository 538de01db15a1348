import type { MazeData, Mouse } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { drivingWorld, driveOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import { createBench, type Bench, type Order } from '../live/bench';
import { createEveryone, type Everyone } from '../live/everyone';
import { createMazeChoice } from '../choice/maze-choice';
import { createWorldChoice } from '../choice/world-choice';
import { createMouseChoice } from '../choice/mouse-choice';
import { withoutRemarks } from '../link/my-robot';
import { isMaze } from '../maze/same';
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
  is_stochastic: false,
  parameters: [],
};

/** The forms at the side: mouse, maze, world, seed and budget. */
function createForms(page: Page, changed: () => void, everyone: () => Everyone) {
  const { rules } = page.about;
  const mice = page.about.mice.filter(({ walks }) => walks !== false);
  let maze: MazeData | null = null;
  /** What the table of all mice says is of another contest. */
  const another = () => (everyone().clear(), changed());
  const mouse = createMouseChoice(mice.some(({ name }) => name === oracle.name) ? mice : [...mice, oracle], changed);
  const mazes = createMazeChoice(page, (next) => {
    maze = next;
    another();
  });
  const seed = h('input', { type: 'number', min: 0, step: 1, value: 1, oninput: another });
  const budget = h('input', { type: 'number', min: 1, step: 1, value: rules.budget, oninput: another });
  const budgetRow = field('Budget', budget, h('span', `limit for both runs together; ${rules.budget} in contests`));
  const seedRow = field('Seed', seed);
  const single = page.about.worlds.filter((one) => one.in_steps || one === drivingWorld(page.about));
  const world = createWorldChoice(page.about, () => (showWorld(), changed()), single);
  function showWorld() {
    budgetRow.hidden = everyone().button.hidden = world.drive() !== null;
    if (world.drive()) everyone().clear();
    mouse.playIn(world.drive() ? 'seconds' : 'steps');
  }
  return {
    mouse,
    mazes,
    seed,
    budget,
    world,
    rows: h('div.field-row', seedRow, budgetRow),
    showWorld,
    maze: () => maze,
    order(): Order | null {
      // What is empty is no number, and no 0: the core says so.
      const numbers = { seed: seed.valueAsNumber, budget: budget.valueAsNumber };
      return maze && { spec: mouse.spec(), maze, ...numbers, drive: world.drive() };
    },
    /** Says it at the field that it names. */
    complain: (message: string) => complainAt({ seed: seedRow, budget: budgetRow, mouse }, 'mouse', message),
  };
}

type Forms = ReturnType<typeof createForms>;

function sideOf({ mouse, mazes, world, rows }: Forms, everyone: Everyone) {
  const contest = [h('h2', 'Contest'), world.element, rows, everyone.button];
  const card = h('section.card', { 'aria-label': 'Contest' }, ...contest);
  return h('div.desk-side', mouse.element, mazes.element, mouse.parameters, card);
}

/** Opens and shows the field with a complaint. */
function showComplaint(side: HTMLElement) {
  const row = side.querySelector('[aria-invalid]')?.closest('.field');
  const closed = row?.closest('details');
  if (closed) closed.open = true;
  row?.scrollIntoView({ block: 'nearest' });
}

async function addressFor(page: Page, { spec, maze, seed, budget, drive }: Order, moment = {}) {
  const place = await placeOf(page.core, page.about, maze);
  const steps = drive || budget === page.about.rules.budget ? {} : { budget };
  const driven = drive && { rules: drive.rules, robot: withoutRemarks(drive.robot) };
  return addressOf('live', { mice: [spec], ...place, seeds: [seed], ...steps, ...driven, ...moment });
}

/** Sets the forms to what a link says; gives back what then chooses its maze, and says whether it has one. */
async function setForms(
  page: Page,
  { mouse, mazes, seed, budget, world, showWorld }: Forms,
  bench: Bench,
  link: Moment,
) {
  if (link.mice.length > 1 || link.seeds.length > 1)
    throw new Error('This link cannot be followed: Live runs one mouse from one seed.');
  const drive = driveOf(link, page.about);
  if (link.mice.length > 0) mouse.choose(link.mice[0]);
  if (link.seeds.length > 0) seed.value = String(link.seeds[0]);
  if (link.budget !== undefined) budget.value = String(link.budget);
  if (drive || link.mice.length > 0) (drive ? world.choose(drive.world, { ...drive }) : world.choose(), showWorld());
  if (link.time !== undefined || link.look) bench.begin(link);
  const maze = await mazeAt(page.core, link);
  return () => {
    if (maze && link.builtin.length > 0) mazes.choose(link.builtin[0]);
    else if (maze) mazes.give(maze);
    return maze !== null;
  };
}

/** The address says what is shown, so that a reload or a shared link shows the same. */
function createShownAddress(page: Page, isShown: () => boolean) {
  let written = '';
  const { ask } = createLatest(
    (now: Order) => addressFor(page, now),
    (text) => {
      written = `#${text}`;
      void page.shelf.write('live', written);
      if (isShown()) history.replaceState(null, '', written);
    },
    () => undefined,
    300,
  );
  return { show: ask, written: () => written, set: (hash: string) => void (written = hash) };
}

/** The view Live: one mouse in one maze, run at once. It accepts mazes. */
export function createLive(page: Page): LiveView {
  let isShown = false;
  const address = createShownAddress(page, () => isShown);
  const forms = createForms(page, changed, () => everyone);
  const { mouse, mazes, seed, order } = forms;
  const bench = createBench(page, (message) => {
    forms.complain(message);
    if (message) showComplaint(side);
  });
  const everyone: Everyone = createEveryone(page, order, (spec, itsSeed) => {
    mouse.choose(spec);
    seed.value = String(itsSeed);
    changed();
    scrollTo({ top: 0, behavior: 'instant' });
  });
  const side = sideOf(forms, everyone);
  function changed() {
    const now = order();
    if (!now || !isShown) return;
    bench.run(now);
    if (Number.isFinite(now.seed) && (now.drive || Number.isFinite(now.budget))) address.show(now);
  }
  /** Runs again; a drawing may have changed. */
  function refresh() {
    if (forms.maze() && !mazes.isDrawing()) changed();
    else mazes.refresh();
  }
  const main = h('div.desk-main', bench.element, everyone.element);
  return {
    element: h('section.live', { 'aria-label': 'Live' }, h('div.desk', side, main)),
    maze: forms.maze,
    shown() {
      isShown = true;
      refresh();
    },
    async follow(hash) {
      if (hash === address.written()) return;
      const goTo = await setForms(page, forms, bench, readAddress(hash).moment);
      address.set(hash);
      if (!goTo()) refresh();
    },
    async address() {
      const now = order();
      if (!now || !Number.isSafeInteger(now.seed) || !Number.isSafeInteger(now.budget)) return 'live';
      return addressFor(page, now, bench.moment());
    },
    hidden() {
      isShown = false;
      bench.stop();
    },
    accept(thing) {
      if (!isMaze(thing)) return;
      mazes.give(thing);
      // What stands in the address is older than this.
      address.set(location.hash);
    },
  };
}
