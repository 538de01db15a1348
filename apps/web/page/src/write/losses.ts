// What a program lost where, maze by maze; each contest is a click away from its replay.
import { h } from '../ui/dom';
import type { Held } from './contest';

const number = (value: number | null) => (value === null ? '–' : value.toFixed(1));

/** How far a contest stayed behind the best possible score; a failed one lost all. */
const lossOf = ({ play }: Held) => (play.score === null || play.bound === null ? Infinity : play.score - play.bound);

/** The most costly maze first. `open` shows a contest. */
export function losses(contests: Held[], open: (held: Held) => void): HTMLElement {
  const sorted = [...contests].sort((a, b) => lossOf(b) - lossOf(a));
  const row = (held: Held) => {
    const { play } = held;
    const loss = lossOf(held);
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, h('button', { type: 'button', onclick: () => open(held) }, play.maze.name)),
      h('td', {}, play.solved ? number(play.score) : play.outcome),
      h('td', {}, number(play.bound)),
      h('td', {}, loss === Infinity ? '–' : number(loss)),
      h('td', {}, play.solved ? String(play.exploration_steps) : '–'),
      h('td', {}, play.solved && play.optimum !== null ? String(play.speed_steps - play.optimum) : '–'),
    );
  };
  const heading = (text: string, title: string) => h('th', { scope: 'col', title }, text);
  return h(
    'div',
    { class: 'losses', tabindex: 0, role: 'region', 'aria-label': 'What it lost where' },
    h(
      'table',
      {},
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          heading('maze', 'Choose one to see the contest'),
          heading('score', 'speed-run steps + exploration steps / 30; lower is better'),
          heading('best', 'the best possible score of this maze'),
          heading('lost', 'the score above the best possible'),
          heading('explor. steps', 'each costs a thirtieth of a step of the speed run'),
          heading('steps too many', 'of the speed run, above those of the shortest one'),
        ),
      ),
      h('tbody', {}, ...sorted.map(row)),
    ),
  );
}
