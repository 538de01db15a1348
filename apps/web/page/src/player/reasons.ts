// Why the mouse went where it went: what it weighed in its last choice, as a table and in words.
import type { Candidate, Reasons } from '../core/types';
import { h } from '../ui/dom';
import type { Panel, State } from './state';
import { counted, short } from './figures';

const rowsAtFirst = 6;

const nameOf = ({ wall, seen_from: [x, y] }: Candidate) =>
  wall ? `(${wall[0]},${wall[1]}) ${wall[2]}` : `goal (${x},${y})`;

const ranks = new WeakMap<Reasons, number[]>();

/** Positions of candidates: the chosen one first, then those worth the way, the lowest score first. Made once. */
function ranked(reasons: Reasons): number[] {
  const known = ranks.get(reasons);
  if (known) return known;
  const { candidates, chosen } = reasons;
  const first = (a: boolean, b: boolean) => Number(b) - Number(a);
  const order = [...candidates.keys()].sort(
    (a, b) =>
      first(a === chosen, b === chosen) ||
      first(candidates[a].worth, candidates[b].worth) ||
      candidates[a].score - candidates[b].score,
  );
  ranks.set(reasons, order);
  return order;
}

/** In words, where no wall was chosen. */
function verdict({ chosen, known, hope, price, candidates }: Reasons): string {
  const run = known > 0 ? `The best known run takes ${short(known)} steps.` : 'No run is known yet.';
  if (chosen >= 0) return known > 0 ? run : '';
  if (candidates.length === 0) return `${run} No unseen wall is left that a better run could pass.`;
  if (hope <= 0) return run;
  return `${run} The best hope is one of ${short(hope)}; looking at it costs ${short(price)}. Not worth it.`;
}

const titleOf = ({ frame, ground, candidates }: Reasons) =>
  `Before step ${frame + 1}: ${ground || counted(candidates.length, 'candidate')}`;

interface Row {
  element: HTMLTableRowElement;
  name: HTMLElement;
  numbers: HTMLElement[];
}

function makeRow(): Row {
  const name = h('th', { scope: 'row' });
  const numbers = Array.from({ length: 4 }, () => h('td'));
  return { element: h('tr', {}, name, ...numbers), name, numbers };
}

function fill({ element, name, numbers }: Row, candidate: Candidate, chosen: boolean) {
  element.className = chosen ? 'chosen' : candidate.worth ? '' : 'unworthy';
  name.textContent = (chosen ? '▸ ' : candidate.worth ? '' : '– ') + nameOf(candidate);
  numbers[0].textContent = `(${candidate.seen_from[0]},${candidate.seen_from[1]})`;
  numbers[1].textContent = candidate.through.toFixed(2);
  numbers[2].textContent = short(candidate.travel);
  numbers[3].textContent = candidate.score.toFixed(2);
}

export function createReasons(state: State): Panel {
  const columns = ['wall', 'seen from', 'through', 'travel', 'score'];
  const title = h('p', { class: 'choice' });
  const words = h('p', { class: 'note' });
  const more = h('button', { type: 'button', class: 'quiet', onclick: () => ((everything = !everything), draw()) });
  const body = h('tbody');
  const caption =
    'All in steps. Through: the speed run through that wall, as far as the mouse considers it; travel: the way to the ' +
    'cell from which it can be seen; score: the value compared, the lowest wins. – not worth the way';
  const table = h(
    'div',
    { class: 'wide', role: 'region', tabindex: 0, 'aria-label': 'Candidates' },
    h(
      'table',
      {},
      h('caption', {}, caption),
      h('thead', {}, h('tr', {}, ...columns.map((name) => h('th', { scope: 'col' }, name)))),
      body,
    ),
  );
  const element = h('section', { class: 'reasons' }, h('h3', {}, 'Reasons'), title, words, table, more);
  const rows: Row[] = [];
  let shown: Reasons | null | undefined;
  let everything = false;

  function drawTable(reasons: Reasons) {
    const order = ranked(reasons);
    const count = everything ? order.length : Math.min(order.length, rowsAtFirst);
    while (rows.length < count) {
      rows.push(makeRow());
      body.append(rows[rows.length - 1].element);
    }
    rows.forEach((row, i) => {
      row.element.hidden = i >= count;
      if (i < count) fill(row, reasons.candidates[order[i]], order[i] === reasons.chosen);
    });
    more.hidden = order.length <= rowsAtFirst;
    more.textContent = everything ? 'fewer' : `and ${order.length - rowsAtFirst} more`;
  }
  function draw() {
    const reasons = shown ?? null;
    title.textContent = reasons ? titleOf(reasons) : 'No choice yet.';
    words.textContent = reasons ? verdict(reasons) : '';
    table.hidden = !reasons || reasons.candidates.length === 0;
    more.hidden = true;
    if (reasons && !table.hidden) drawTable(reasons);
  }
  return {
    element,
    update() {
      const { track, scene } = state.sides[state.chosen];
      element.hidden = track.play.reasons.length === 0;
      const at = track.reasons[scene.past.frame];
      const reasons = at < 0 ? null : track.play.reasons[at];
      if (reasons === shown) return;
      shown = reasons;
      draw();
    },
  };
}
