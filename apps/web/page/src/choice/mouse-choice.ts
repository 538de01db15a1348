// Which mouse runs, with which parameters.
import type { Mouse, Parameter } from '../core/types';
import { createCopyable } from '../ui/copy';
import { button, select } from '../ui/controls';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import { createParameters } from './parameters';
import { readSpec, specOf, type Values } from './spec';

/** The one to begin with: it has parameters, and reasons. */
const isUsual = (name: string) => name === 'ariadne';

const cardsOf = (row: HTMLElement, spec: HTMLElement, reset: HTMLElement, parameters: HTMLElement) => ({
  element: h(
    'section.card',
    { 'aria-label': 'Mouse' },
    h('h2', 'Mouse'),
    row,
    h('div.field', h('span.label', 'For the command line'), spec),
  ),
  parameters: h(
    'details.card',
    { open: matchMedia('(min-width: 60rem)').matches },
    h('summary', h('h2', 'Parameters')),
    reset,
    parameters,
  ),
});

export function createMouseChoice(mice: Mouse[], changed: () => void) {
  let mouse = (mice.find(({ name }) => isUsual(name)) ?? mice[0]).name;
  let values: Values = {};
  let unit: 'steps' | 'seconds' = 'steps';
  const list = select(
    mice.map(({ name, summary }) => [name, `${name} · ${summary}`]),
    (name) => choose(name, {}),
  );
  const summary = h('span');
  const row = field('Name', list, summary);
  const parameters = createParameters((next) => {
    // What the form does not show stays until another mouse is chosen or all go back to their defaults.
    values = { ...unknown(), ...next };
    update();
    changed();
  });
  const copyable = createCopyable('The mouse for the command line', 'Copy');
  const reset = button('Back to defaults', () => choose(mouse, {}));

  const counts = ({ counts_in }: Parameter) => !counts_in || counts_in === unit;
  const entry = () => mice.find(({ name }) => name === mouse);
  const spec = () => specOf(mouse, values, mice);
  function unknown(): Values {
    const known = (entry()?.parameters ?? []).filter(counts).map(({ name }) => name);
    return Object.fromEntries(Object.entries(values).filter(([name]) => !known.includes(name)));
  }
  function update() {
    list.value = mouse;
    summary.replaceChildren(entry()?.summary ?? '');
    const whole = entry() ?? { name: mouse, summary: '', is_stochastic: false, parameters: [] };
    parameters.show({ ...whole, parameters: whole.parameters.filter(counts) }, values);
    copyable.show(spec());
    reset.disabled = spec() === mouse;
  }
  function set(name: string, next: Values) {
    mouse = name;
    values = { ...next };
    update();
  }
  const choose = (name: string, next: Values) => (set(name, next), changed());
  update();
  return {
    ...cardsOf(row, copyable.element, reset, parameters.element),
    spec,
    /** Shows the parameters that count there. */
    playIn: (where: typeof unit) => ((unit = where), update()),
    /** Another mouse, by its SPEC, right or wrong. */
    choose(text: string) {
      const { mouse, values } = readSpec(text);
      set(mouse, values);
    },
    /** Says at the field that a message of the core speaks of what is wrong; nothing where it is empty. */
    complain(message: string) {
      parameters.clear();
      row.complain('');
      const named = /parameter '([^']*)'/.exec(message)?.[1];
      if (message && !(named && parameters.complain(named, message))) row.complain(message);
    },
  };
}
