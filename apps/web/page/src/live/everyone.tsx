// A race of all mice in one maze, one after the other, so that it can be watched and stopped.
import { useEffect, useRef } from 'preact/hooks';
import type { ContestResult, MazeData } from '../core/types';
import type { Page } from '../page/page';
import { RaceTable, type Row } from './table';
import { errorText } from '../ui/format';
import { Button } from '../ui/controls';

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

/** `draw` is called after each change. */
export function createEveryone(page: Page, task: () => Task | null, draw: () => void) {
  const state = {
    /** Of the race that is shown; empty while none is. */
    caption: '',
    rows: [] as Row[],
    /** How many race. */
    all: 0,
    isRunning: false,
    said: '',
  };
  // Each race has a number; one whose number is past ends.
  let number = 0;

  function finish(said: string) {
    Object.assign(state, { isRunning: false, said });
    draw();
  }
  return {
    state,
    stop() {
      number += 1;
      page.core.stop('race');
      finish('Stopped.');
    },
    async race() {
      const now = task();
      if (!now) return;
      const mine = ++number;
      const specs = specsOf(page, now);
      const caption = `All mice in ${now.maze.name || 'this maze'}, seed ${now.seed}`;
      Object.assign(state, { caption, rows: [], all: specs.length, isRunning: true });
      for (const [i, spec] of specs.entries()) {
        state.said = `${spec} races: ${i + 1} of ${specs.length}`;
        draw();
        const row = await contest(page, spec, now);
        if (mine !== number) return;
        state.rows = [...state.rows, row];
      }
      finish(`${specs.length} mice have raced. Click one to see its walk.`);
    },
    /** What the table says is of another maze, seed or budget: it goes. The view draws it. */
    clear() {
      number += 1;
      Object.assign(state, { caption: '', isRunning: false, said: '' });
    },
  };
}

interface Props {
  everyone: Everyone;
  /** Hears of a mouse whose walk is to be shown, by its SPEC and its seed. */
  pick(spec: string, seed: number): void;
}

/** The race: its progress and its table; hidden before there is one. */
export function EveryoneCard({ everyone: { state, stop }, pick }: Props) {
  const { caption, rows, all, isRunning, said } = state;
  const card = useRef<HTMLElement>(null);
  useEffect(() => void (isRunning && card.current?.scrollIntoView({ block: 'nearest' })), [isRunning]);
  return (
    <section class="card everyone" aria-label="All mice" hidden={caption === ''} ref={card}>
      <h2>All mice</h2>
      <div class="row">
        <p class="note" role="status">
          {said}
        </p>
        <Button label="Stop" hidden={!isRunning} act={stop} />
        <progress hidden={!isRunning} aria-label="Mice that have raced" max={all} value={rows.length} />
      </div>
      <RaceTable caption={caption} rows={rows} pick={({ spec, result }) => result && pick(spec, Number(result.seed))} />
    </section>
  );
}
