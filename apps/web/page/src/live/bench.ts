// Runs what is chosen, at once on every change, and shows the walk.
import type { MazeData } from '../core/types';
import { createPlayer } from '../player/player';
import { h } from '../ui/dom';
import { createLatest } from '../ui/latest';
import type { Page } from '../views/view';
import { comparisonInWords, isSameMaze, type Walk } from './comparison';

export interface Order {
  spec: string;
  maze: MazeData;
  seed: number;
  budget: number;
}

export interface Bench {
  element: HTMLElement;
  run(order: Order): void;
  stop(): void;
}

const steps = (value: number | null) => (value === null ? '–' : `${value} steps`);
const share = (value: number | null) => (value === null ? '–' : `${(100 * value).toFixed(1)} %`);
const score = (value: number | null) => (value === null ? '–' : value.toFixed(3));

/** The figures of a walk, each with what it means. */
function figures({ play }: Walk): [string, string, string][] {
  return [
    ['Score', score(play.score), 'speed run + exploration / 30; less is better'],
    ['Bound', score(play.bound), 'the best possible score here'],
    ['Exploration', steps(play.exploration_steps), 'the first run'],
    ['Speed run', play.solved ? steps(play.speed_steps) : '–', 'the second run'],
    ['Optimum', steps(play.optimum), 'the shortest speed run here'],
    ['Discovered', share(play.discovered), 'of the cells that can be reached'],
    ['Visited', share(play.visited), 'of the cells that can be reached'],
  ];
}

/** `refused` hears why a run could not be, and an empty text where it could. */
export function createBench(page: Page, refused: (message: string) => void): Bench {
  const player = createPlayer(page);
  const outcome = h('p', { role: 'status', class: 'verdict' });
  const list = h('dl', { class: 'figures' });
  const compare = h('input', { type: 'checkbox', onchange: () => show() });
  const beside = h('label', { class: 'check' }, compare, 'Compare with before');
  const words = h('p', { class: 'comparison', 'aria-live': 'polite' });
  const row = h('div', { class: 'row' }, beside, words);
  const element = h('div', { class: 'bench' }, outcome, list, row, player.element);
  let now: Walk | null = null;
  let before: Walk | null = null;

  function show() {
    if (now) player.show(compare.checked && before ? [before, now] : [now]);
  }
  function take(walk: Walk) {
    before = now && isSameMaze(now, walk) ? now : null;
    now = walk;
    refused('');
    element.classList.remove('stale');
    outcome.dataset.state = walk.play.solved ? 'good' : 'bad';
    outcome.replaceChildren(`${walk.spec} in ${walk.play.maze.name || 'this maze'}: ${walk.play.outcome}`);
    list.replaceChildren(
      ...figures(walk).map(([name, value, meaning]) =>
        h('div', { title: meaning }, h('dt', {}, name), h('dd', {}, value)),
      ),
    );
    words.replaceChildren(before ? comparisonInWords(before, walk) : '');
    compare.disabled = before === null;
    show();
  }
  const latest = createLatest(
    async ({ spec, maze, seed, budget }: Order): Promise<Walk> => {
      const answer = await page.core.call('run', { mouse: spec, maze, seed, budget });
      return { spec, seed, budget, ...answer };
    },
    take,
    (error) => {
      element.classList.add('stale');
      refused(error instanceof Error ? error.message : String(error));
    },
    250,
  );
  compare.disabled = true;
  return { element, run: latest.ask, stop: player.stop };
}
