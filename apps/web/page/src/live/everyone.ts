// A race of all mice in one maze, one after the other, so that it can be watched and stopped.
import type { ContestResult, MazeData } from '../core/types';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import type { Page } from '../page/page';
import { createTable, type Row } from './table';
import { errorText } from '../ui/format';

export interface Task {
  maze: MazeData;
  seed: number;
  budget: number;
  /** The SPEC of the mouse that is chosen; it races along. */
  spec: string;
}

export type Everyone = ReturnType<typeof createEveryone>;

const isReference = (name: string) => name === 'oracle';

async function contest(page: Page, spec: string, { maze, seed, budget }: Task): Promise<Row> {
  const base = { spec, isReference: isReference(spec) };
  try {
    const { results } = await page.core.call('race', { mice: [spec], mazes: [maze], seed, runs: 1, budget });
    const [mouse] = results.groups[0].mice;
    const result: ContestResult = mouse.results[0];
    return { ...base, result, ratio: mouse.mean_ratio, outcome: result.outcome };
  } catch (error) {
    return { ...base, result: null, ratio: null, outcome: errorText(error) };
  }
}

/** All that run in steps, the oracle, and the one that is chosen. */
const specsOf = ({ about }: Page, { spec }: Task) => {
  const walkers = about.mice.filter(({ walks }) => walks !== false).map(({ name }) => name);
  return [...new Set([...walkers, 'oracle', spec])];
};

/** `pick` hears of a mouse whose walk is to be shown, by its SPEC and its seed. */
export function createEveryone(page: Page, task: () => Task | null, pick: (spec: string, seed: number) => void) {
  const table = createTable((row) => row.result && pick(row.spec, Number(row.result.seed)));
  const progress = h('progress', { hidden: true, 'aria-label': 'Mice that have raced' });
  const said = h('p.note', { role: 'status' });
  const begin = button('Race all mice on this maze', race);
  const end = button('Stop', stop, { hidden: true });
  // Each race has a number; one whose number is past ends.
  let number = 0;

  function stop() {
    number += 1;
    page.core.stop('race');
    finish('Stopped.');
  }
  const content = [h('h2', 'All mice'), h('div.row', said, end, progress), table.element];
  const element = h('section.card.everyone', { 'aria-label': 'All mice', hidden: true }, ...content);
  function finish(words: string) {
    progress.hidden = end.hidden = true;
    begin.disabled = false;
    said.replaceChildren(words);
  }
  async function race() {
    const now = task();
    if (!now) return;
    const mine = ++number;
    element.hidden = false;
    element.scrollIntoView({ block: 'nearest' });
    const specs = specsOf(page, now);
    table.begin(`All mice in ${now.maze.name || 'this maze'}, seed ${now.seed}`);
    progress.max = specs.length;
    progress.value = 0;
    progress.hidden = end.hidden = false;
    begin.disabled = true;
    for (const spec of specs) {
      said.replaceChildren(`${spec} races: ${progress.value + 1} of ${specs.length}`);
      const row = await contest(page, spec, now);
      if (mine !== number) return;
      table.add(row);
      progress.value += 1;
    }
    finish(`${specs.length} mice have raced. Click one to see its walk.`);
  }
  return {
    /** The race: its progress and its table; hidden before there is one. */
    element,
    /** Begins it. */
    button: begin,
    /** What the table says is of another maze, seed or budget: it goes. */
    clear() {
      number += 1;
      finish('');
      element.hidden = true;
    },
  };
}
