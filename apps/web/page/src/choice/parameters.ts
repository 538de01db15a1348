// The parameters of a mouse as a form, built from its table.
import type { Mouse, Parameter } from '../core/types';
import { h } from '../ui/dom';
import { field, type Field } from '../ui/field';
import { valueOf, type Values } from './spec';

type Control = HTMLInputElement | HTMLSelectElement;

/** More choices than that are easier to find by typing. */
const longList = 12;

/** What is given has to be shown, even where it is no choice: the core says what is wrong with it. */
const withGiven = (choices: string[], value: string) => (choices.includes(value) ? choices : [value, ...choices]);

function selectOf(parameter: Parameter, value: string): Control {
  const options = withGiven(parameter.choices ?? [], value);
  return h('select', ...options.map((one) => h('option', { value: one, selected: one === value }, one)));
}

function listed(parameter: Parameter, value: string, id: string): [Control, HTMLElement] {
  const options = (parameter.choices ?? []).map((one) => h('option', { value: one }));
  const control = h('input', { type: 'text', list: id, value, spellcheck: 'false', autocomplete: 'off' });
  return [control, h('datalist', { id }, ...options)];
}

/** The core has longer names for some types where it writes for people. */
const types: Record<string, Parameter['type']> = { 'whole number': 'whole', number: 'real', 'yes/no': 'flag' };
const typeOf = ({ type }: Parameter) => types[type] ?? type;
const isNumber = (parameter: Parameter) => typeOf(parameter) === 'whole' || typeOf(parameter) === 'real';

export function controlOf(parameter: Parameter, value: string): [Control, ...HTMLElement[]] {
  const { low, high, choices = [] } = parameter;
  if (typeOf(parameter) === 'flag') return [h('input', { type: 'checkbox', checked: value === 'yes' })];
  if (isNumber(parameter)) {
    const step = typeOf(parameter) === 'whole' ? 1 : 'any';
    return [h('input', { type: 'number', inputmode: 'decimal', min: low, max: high, step, value })];
  }
  if (choices.length > longList) return listed(parameter, value, `choices-${parameter.name}`);
  if (choices.length > 0) return [selectOf(parameter, value)];
  return [h('input', { type: 'text', value, spellcheck: 'false', autocomplete: 'off' })];
}

/** The value in a control, as the SPEC has it; null where the browser can make nothing of what stands there. */
export function read(control: Control): string | null {
  if (control instanceof HTMLInputElement && control.type === 'checkbox') return control.checked ? 'yes' : 'no';
  return control.validity.badInput ? null : control.value.trim();
}

function helpFor(parameter: Parameter): HTMLElement {
  const { meaning, low, high } = parameter;
  const range = isNumber(parameter) && low !== undefined ? `; ${low} to ${high}` : '';
  return h('span', `${meaning}${range}; default ${parameter.default}`);
}

/** `changed` hears of the values that are not the default. */
export function createParameters(changed: (values: Values) => void) {
  const element = h('div.parameters');
  const fields = new Map<string, Field>();
  let shown = '';

  let names: string[] = [];
  const keyOf = (mouse: string, values: Values) => JSON.stringify([mouse, values, names]);

  function rowOf(mouse: string, parameter: Parameter, given: Values) {
    const [control, ...beside] = controlOf(parameter, valueOf(parameter, given));
    const row = field(parameter.name, control, helpFor(parameter));
    row.classList.toggle('check', typeOf(parameter) === 'flag');
    row.append(...beside);
    fields.set(parameter.name, row);
    control.addEventListener('input', () => {
      const value = read(control);
      row.complain(value === null ? 'not a number' : '');
      if (value === null) return;
      delete given[parameter.name];
      if (value !== '' && value !== parameter.default) given[parameter.name] = value;
      shown = keyOf(mouse, given);
      changed({ ...given });
    });
    return row;
  }
  return {
    element,
    /** The table of another mouse, or other values. */
    show(mouse: Mouse, values: Values) {
      // A form that shows this already is left alone, with the focus in it.
      names = mouse.parameters.map(({ name }) => name);
      const now = keyOf(mouse.name, values);
      if (now === shown) return;
      shown = now;
      fields.clear();
      const given = { ...values };
      element.replaceChildren(...mouse.parameters.map((one) => rowOf(mouse.name, one, given)));
      if (mouse.parameters.length === 0) element.append(h('p.note', 'This mouse has no parameters.'));
    },
    /** Says at that parameter what is wrong with it; false where the mouse has none of that name. */
    complain(name: string, message: string) {
      fields.get(name)?.complain(message);
      return fields.has(name);
    },
    clear: () => fields.forEach((one) => one.complain('')),
  };
}
