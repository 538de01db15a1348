import type { MazeData, Mouse } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { drivingWorld, driveOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import { BenchRoom, createBench, type Bench, type Order } from '../live/bench';
import { createEveryone, EveryoneCard } from '../live/everyone';
import { createRobotPart, RobotCard } from '../live/robot-card';
import { createMazeChoice, MazeCard } from '../choice/maze-choice';
import { createWorldChoice, WorldFields } from '../choice/world-choice';
import { createMouseChoice, MouseCard, ParametersCard } from '../choice/mouse-choice';
import { withoutRemarks } from '../link/my-robot';
import { isMaze } from '../maze/same';
import { Button, NumberInput, numberOf } from '../ui/controls';
import { errorAt, Field } from '../ui/field';
import { createLatest } from '../ui/latest';
import { createRoot } from '../ui/root';
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

/** The forms at the side: mouse, maze, world, seed and budget. `another` hears where it is another contest for all mice. */
function createForms(page: Page, changed: () => void, another: () => void, draw: () => void) {
  const { rules } = page.about;
  const mice = page.about.mice.filter(({ walks }) => walks !== false);
  const state = { maze: null as MazeData | null, seed: '1', budget: String(rules.budget), error: '' };
  const mouse = createMouseChoice(mice.some(({ name }) => name === oracle.name) ? mice : [...mice, oracle], changed);
  const set = (changes: Partial<typeof state>) => {
    Object.assign(state, changes);
    another();
  };
  const mazes = createMazeChoice(page, (maze) => set({ maze }), draw);
  const single = page.about.worlds.filter((one) => one.in_steps || one === drivingWorld(page.about));
  const world = createWorldChoice(page.about, () => (enter(), another()), single);
  /** What is shown of the mouse is what counts in the chosen world. */
  const enter = () => mouse.playIn(world.drive() ? 'seconds' : 'steps');
  return {
    rules,
    state,
    mouse,
    mazes,
    world,
    set,
    enter,
    order(): Order | null {
      const { maze, seed, budget } = state;
      // What is empty is no number, and no 0: the core says so.
      const numbers = { seed: numberOf(seed), budget: numberOf(budget) };
      return maze && { spec: mouse.spec(), maze, ...numbers, drive: world.drive() };
    },
    /** Says it at the field that it names. */
    complain(message: string) {
      state.error = message;
      mouse.complain(errorAt(message, ['seed', 'budget', 'mouse'], 'mouse')('mouse'));
    },
  };
}

type Forms = ReturnType<typeof createForms>;

/** `race` lets all mice race; null while they do. */
function Side({ forms, race }: { forms: Forms; race: (() => void) | null }) {
  const { rules, state, mouse, mazes, world, set } = forms;
  const drives = world.drive() !== null;
  const at = errorAt(state.error, ['seed', 'budget', 'mouse'], 'mouse');
  return (
    <div class="desk-side">
      <MouseCard choice={mouse} />
      <MazeCard choice={mazes} />
      <ParametersCard choice={mouse} />
      <section class="card" aria-label="Contest">
        <h2>Contest</h2>
        <WorldFields choice={world} />
        <div class="field-row">
          <Field label="Seed" error={at('seed')}>
            <NumberInput min={0} value={state.seed} change={(seed) => set({ seed })} />
          </Field>
          <Field
            label="Budget"
            help={`limit for both runs together; ${rules.budget} in contests`}
            error={at('budget')}
            hidden={drives}
          >
            <NumberInput min={1} value={state.budget} change={(budget) => set({ budget })} />
          </Field>
        </div>
        <Button label="Race all mice on this maze" disabled={!race} hidden={drives} act={() => race?.()} />
      </section>
    </div>
  );
}

/** Opens and shows the field with a complaint. */
function showComplaint(view: HTMLElement) {
  const row = view.querySelector('[aria-invalid]')?.closest('.field');
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
async function setForms(page: Page, { state, mouse, mazes, world, enter }: Forms, bench: Bench, link: Moment) {
  if (link.mice.length > 1 || link.seeds.length > 1)
    throw new Error('This link cannot be followed: Live runs one mouse from one seed.');
  const drive = driveOf(link, page.about);
  if (link.mice.length > 0) mouse.choose(link.mice[0]);
  if (link.seeds.length > 0) state.seed = String(link.seeds[0]);
  if (link.budget !== undefined) state.budget = String(link.budget);
  if (drive || link.mice.length > 0) (drive ? world.choose(drive.world, { ...drive }) : world.choose(), enter());
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

/** The parts of the view, and what they do to each other. */
function createParts(page: Page) {
  const state = { isShown: false };
  const address = createShownAddress(page, () => state.isShown);
  const { element, draw } = createRoot('live', 'Live', () => (
    <div class="desk">
      <Side forms={forms} race={everyone.state.isRunning ? null : () => void everyone.race()} />
      <div class="desk-main">
        <BenchRoom bench={bench} />
        <EveryoneCard everyone={everyone} pick={pick} />
        <RobotCard part={robot} maze={forms.state.maze} />
      </div>
    </div>
  ));
  const forms = createForms(page, changed, another, draw);
  const { mouse, mazes, order } = forms;
  const bench = createBench(page, (message) => {
    forms.complain(message);
    draw();
    if (message) showComplaint(element);
  });
  const everyone = createEveryone(page, order, draw);
  const robot = createRobotPart(page, draw);
  /** What the table of all mice says is of another contest. */
  function another() {
    everyone.clear();
    changed();
  }
  function pick(spec: string, seed: number) {
    mouse.choose(spec);
    forms.state.seed = String(seed);
    changed();
    scrollTo({ top: 0, behavior: 'instant' });
  }
  function changed() {
    draw();
    const now = order();
    if (!now || !state.isShown) return;
    bench.run(now);
    if (Number.isFinite(now.seed) && (now.drive || Number.isFinite(now.budget))) address.show(now);
  }
  /** Runs again; a drawing may have changed. */
  function refresh() {
    if (forms.state.maze && !mazes.isDrawing()) changed();
    else mazes.refresh();
  }
  draw();
  return { element, state, address, forms, bench, refresh };
}

/** The view Live: one mouse in one maze, run at once. It accepts mazes. */
export function createLive(page: Page): LiveView {
  const { element, state, address, forms, bench, refresh } = createParts(page);
  return {
    element,
    maze: () => forms.state.maze,
    shown() {
      state.isShown = true;
      refresh();
    },
    async follow(hash) {
      if (hash === address.written()) return;
      const goTo = await setForms(page, forms, bench, readAddress(hash).moment);
      address.set(hash);
      if (!goTo()) refresh();
    },
    async address() {
      const now = forms.order();
      if (!now || !Number.isSafeInteger(now.seed) || !Number.isSafeInteger(now.budget)) return 'live';
      return addressFor(page, now, bench.player.moment());
    },
    hidden() {
      state.isShown = false;
      bench.player.stop();
    },
    accept(thing) {
      if (!isMaze(thing)) return;
      forms.mazes.give(thing);
      // What stands in the address is older than this.
      address.set(location.hash);
    },
  };
}
