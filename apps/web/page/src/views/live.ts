import type { MazeData, Mouse } from '../core/types';
import { addressOf, readAddress } from '../live/address';
import { createBench } from '../live/bench';
import { createEveryone } from '../live/everyone';
import { createMazeChoice } from '../live/maze-choice';
import { createWorldChoice } from '../live/world-choice';
import { createMouseChoice } from '../live/mouse-choice';
import { h } from '../ui/dom';
import { complainAt, field } from '../ui/field';
import { createLatest } from '../ui/latest';
import type { Page, View } from './view';
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
  const { mice, rules } = page.about;
  let maze: MazeData | null = null;
  let written = '';
  let isShown = false;

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
  const world = createWorldChoice(page.about, () => (showWorld(), changed()));
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
    async (now: NonNullable<ReturnType<typeof order>>) => (await page.core.call('link', { maze: now.maze })).link,
    (link, now) => {
      const usual = now.drive || now.budget === rules.budget;
      const budget = usual ? undefined : now.budget;
      const text = addressOf({ mouse: now.spec, maze: link, seed: now.seed, budget, ...now.drive });
      written = `#${text}`;
      if (isShown) history.replaceState(null, '', written);
    },
    () => undefined,
    300,
  );
  async function follow() {
    const wanted = location.hash === written ? null : readAddress(location.hash);
    if (wanted?.mouse) mouse.choose(wanted.mouse);
    if (wanted?.seed !== undefined) seed.value = String(wanted.seed);
    if (wanted?.budget !== undefined) budget.value = String(wanted.budget);
    if (wanted?.robot || wanted?.mouse) (world.choose(wanted.robot, wanted.rules), showWorld());
    if (wanted?.maze) {
      written = location.hash;
      try {
        return mazes.give((await page.core.call('read_link', { link: wanted.maze })).maze);
      } catch (error) {
        page.complain(error);
      }
    }
    if (maze && !mazes.isDrawing()) changed();
    else mazes.refresh();
  }
  addEventListener('hashchange', () => isShown && readAddress(location.hash) && void follow());

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
      void follow();
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
