// The runs of a contest in seconds, as a list: what each was, how long it took, what it is worth.
import type { Drive } from '../core/types';
import { h } from '../ui/dom';
import { durationText, gateToGate, kinds, madeOf } from './drive';
import type { Actions, Panel, Side, State } from './state';

const heads = ['run', 'begins', 'takes', 'gate to gate', 'known, hoped for', 'counts'];

/** Two times of one run stand side by side: what each is, and which of them counts. */
const timedBy = ({ gate_to_gate }: Drive['rules']) =>
  'A run takes its time from rest at the start to the middle of a goal; from gate to gate is the part from leaving the ' +
  `start cell to entering a goal. These rules count ${gate_to_gate ? 'the time from gate to gate' : 'the whole time from rest'}.`;

export function createRuns(state: State, actions: Actions): Panel {
  const element = h('section', { class: 'drive-runs', hidden: true });
  let shown: Side[] = [];
  let rows: { side: Side; run: number; row: HTMLElement }[] = [];

  function line(side: Side, index: number): HTMLElement {
    const { runs, drive } = side.track.drive!;
    const run = runs[index];
    const jump = () => {
      actions.choose(state.sides.indexOf(side));
      actions.seek(run.begin / 1e6);
    };
    const hoped = run.known === run.hoped ? 'proven' : durationText(run.hoped);
    const known = `${durationText(run.known)}, ${hoped}`;
    const value = run.score ? durationText(run.score.value) : '–';
    const row = h(
      'tr',
      { class: run.score?.best ? 'best' : '' },
      h('th', { scope: 'row' }, h('button', { type: 'button', onclick: jump }, `${index + 1} ${kinds[run.kind]}`)),
      h('td', {}, durationText(run.begin)),
      h('td', {}, durationText(run.end - run.begin)),
      h('td', {}, durationText(gateToGate(run))),
      h('td', {}, run.known === null && run.hoped === null ? '–' : known),
      h('td', { title: madeOf(run, drive.rules) }, run.score?.best ? h('strong', {}, value, ' best') : value),
    );
    rows.push({ side, run: index, row });
    return row;
  }
  function table(side: Side): HTMLElement {
    const { drive, runs } = side.track.drive!;
    return h(
      'div',
      { class: 'wide', tabindex: 0, role: 'region', 'aria-label': `Runs of ${side.name}` },
      h(
        'table',
        {},
        h('caption', {}, `${side.name}: robot ${drive.robot.name}, rules ${drive.rules.name}. ${timedBy(drive.rules)}`),
        h('thead', {}, h('tr', {}, ...heads.map((text) => h('th', { scope: 'col' }, text)))),
        h('tbody', {}, ...runs.map((_, i) => line(side, i))),
      ),
    );
  }
  function rebuild() {
    shown = state.sides;
    rows = [];
    const driven = shown.filter(({ track }) => track.drive);
    element.hidden = driven.length === 0;
    element.replaceChildren(h('h3', {}, 'Runs'), ...driven.map(table));
  }
  return {
    element,
    update() {
      if (shown !== state.sides) rebuild();
      for (const { side, run, row } of rows) {
        const is = side.scene.moment?.run === run;
        if (is === row.hasAttribute('aria-current')) continue;
        if (is) row.setAttribute('aria-current', 'true');
        else row.removeAttribute('aria-current');
      }
    },
  };
}
