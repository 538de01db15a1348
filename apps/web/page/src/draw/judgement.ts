// What the core says about the drawing while it changes.
import type { Inspection, MazeData } from '../core/types';
import { h } from '../ui/dom';
import { meanings } from '../ui/meanings';
import { boundMeaning, mmsBoundMeaning, optimumMeaning } from '../ui/terms';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';
import { counted, errorText, number } from '../ui/format';

/** After so many milliseconds without an answer, the last one is taken back: it speaks of another drawing. */
const patience = 200;

const countOf = (value: number | null, one: string) => (value === null ? '–' : counted(value, one));
const arrives = (value: boolean) => (value ? 'arrives' : 'does not arrive');

/** The figures, each with what it means. */
function figures(found: Inspection, cells: number): [string, string, string][] {
  return [
    ['Shortest run', countOf(found.optimum, 'step'), optimumMeaning],
    ['Best possible', number(found.bound, 3), boundMeaning],
    ['Best in mms', number(found.mms_score, 3), mmsBoundMeaning],
    ['Shortest path', countOf(found.shortest_cells, 'cell'), 'from the start to the nearest goal'],
    ['Reachable', `${found.reachable} of ${cells} cells`, 'from the start'],
    ['Dead ends', number(found.dead_ends, 0), 'cells with only one way in'],
    ['Junctions', number(found.junctions, 0), 'cells with three or four ways'],
    ['Loops', number(found.loops, 0), 'walls that could be closed without cutting off any cell'],
    ['Left hand', arrives(found.left_follower_arrives), 'a mouse with its left hand on the wall'],
    ['Right hand', arrives(found.right_follower_arrives), 'a mouse with its right hand on the wall'],
  ];
}

/** The most important thing about a drawing. */
function verdict(found: Inspection): { words: string; state: 'good' | 'fair' | 'bad' } {
  if (found.optimum === null) return { words: 'No goal can be reached from the start.', state: 'bad' };
  const broken = found.contest_rules.filter((rule) => !rule.passed).length;
  const all = found.contest_rules.length;
  if (broken === 0) return { words: `A contest maze: it follows all ${all} rules.`, state: 'good' };
  return { words: `The goal can be reached; ${broken} of ${all} contest rules are broken.`, state: 'fair' };
}

/** Rules that forbid something say so, or they seem to contradict the figures. */
const ruleInWords = (name: string) => (name.endsWith('wall follower') ? `${name} must not arrive` : name);

function rulesList(found: Inspection) {
  const mark = (passed: boolean) =>
    h('span', { class: passed ? 'rule-mark kept' : 'rule-mark broken' }, passed ? '✓ kept' : '✗ broken');
  return found.contest_rules.map(({ name, passed, reason }) =>
    h('li', mark(passed), h('span.rule-name', ruleInWords(name)), reason && h('p', reason)),
  );
}

/** `route` hears of the shortest run of the drawing, and of null while it is not known. */
export function createJudgement(page: Page, route: (found: Inspection | null) => void) {
  const words = h('p.verdict', { role: 'status' });
  const table = h('dl.figures');
  const explained = h('div');
  const rules = h('ul.rules');
  const element = h(
    'section.card',
    { 'aria-label': 'Judgement' },
    h('h2', 'Judgement'),
    words,
    table,
    explained,
    h('details', { open: true }, h('summary', 'Contest rules'), rules),
  );
  let late: ReturnType<typeof setTimeout> | undefined;

  function tell(text: string, state: string) {
    clearTimeout(late);
    late = undefined;
    if (words.textContent !== text) words.replaceChildren(text);
    words.dataset.state = state;
  }
  const latest = createLatest(
    (maze: MazeData) => page.core.call('inspect', { maze }),
    (found, maze) => {
      const { words: text, state } = verdict(found);
      tell(text, state);
      element.classList.remove('stale');
      const all = figures(found, maze.width * maze.height);
      // Open or not, it is as the reader left it.
      if (!explained.hasChildNodes()) explained.append(meanings(all.map(([name, , meaning]) => [name, meaning])));
      table.replaceChildren(
        ...all.map(([name, value, meaning]) => h('div', { title: meaning }, h('dt', name), h('dd', value))),
      );
      rules.replaceChildren(...rulesList(found));
      route(found);
    },
    (error) => {
      tell(errorText(error), 'bad');
      route(null);
    },
  );
  return {
    element,
    judge(maze: MazeData) {
      late ??= setTimeout(() => {
        element.classList.add('stale');
        route(null);
      }, patience);
      latest.ask(maze);
    },
  };
}
