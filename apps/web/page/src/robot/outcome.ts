// What follows from the robot: whether it can be, and its turns, straights and searches.
import type { RobotAnswer, RobotSentence } from '../core/types';
import { h } from '../ui/dom';
import { meanings } from '../ui/meanings';
import { turnMeanings } from '../ui/terms';
import { searchTable, straightTables, turnFigures } from './figures';
import type { RoutePanel } from './route-panel';

/** After so many milliseconds the page says that it is at work. */
const patience = 100;

export function createOutcome(desk: HTMLElement, route: RoutePanel) {
  const status = h('p.verdict', { role: 'status' });
  // Stays in sight while the form scrolls.
  const refusal = h('p.refusal', { role: 'alert' });
  const others = h('ul.robot-sentences');
  const turns = h('div.robot-turns');
  const tables = h('div.robot-tables');
  const follows = h(
    'div.robot-follows',
    h('div', h('h3', 'The best route'), route.times),
    route.saving,
    h('h3', 'Turns'),
    turns,
    meanings(turnMeanings),
    h('h3', 'Straights and the search'),
    tables,
  );
  let late: ReturnType<typeof setTimeout> | undefined;
  function say(text: string, state: 'good' | 'fair' | 'bad') {
    status.dataset.state = state;
    status.replaceChildren(text);
  }
  /** Says after a moment that the core is at work. */
  function wait() {
    clearTimeout(late);
    late = setTimeout(() => {
      desk.setAttribute('aria-busy', 'true');
      say('Computing …', 'fair');
    }, patience);
  }
  return {
    refusal,
    element: h('div.desk-main', status, others, follows),
    wait,
    rest() {
      clearTimeout(late);
      desk.removeAttribute('aria-busy');
    },
    /** `sentences` have no field of their own; `before` is null for the robot that it began from. */
    show({ result, remarks, problems }: RobotAnswer, before: RobotAnswer | null, sentences: RobotSentence[]) {
      others.replaceChildren(...sentences.map(({ text }) => h('li', text)));
      others.hidden = sentences.length === 0;
      desk.classList.toggle('stale', result === null);
      const refused = result ? '' : `Refused: ${problems[0]?.text ?? 'no robot'}`;
      say(result?.line ?? refused, result === null ? 'bad' : remarks.length > 0 ? 'fair' : 'good');
      if (refusal.textContent !== refused) refusal.replaceChildren(refused);
      // What is shown below stays that of the last robot that could be.
      if (!result) return;
      const was = before?.result ?? null;
      turns.replaceChildren(...turnFigures(result, was));
      const search = h('div', h('h4', 'Moves of a search'), searchTable(result, was));
      tables.replaceChildren(...straightTables(result, was), search);
    },
  };
}
