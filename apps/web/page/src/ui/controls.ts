// Controls that stand in many places.
import { h, type Attributes, type Child } from './dom';

/** A button that sends no form. */
export const button = (label: Child, act: () => unknown, more: Attributes = {}): HTMLButtonElement =>
  h('button', { type: 'button', ...more, onclick: () => void act() }, label);

/** A list to choose one from, by value and label; `chosen` hears of each choice. */
export function select(
  options: [value: string | number, label: string][],
  chosen: (value: string) => void = () => undefined,
  more: Attributes = {},
): HTMLSelectElement {
  const element = h('select', more, ...options.map(([value, label]) => h('option', { value }, label)));
  element.addEventListener('change', () => chosen(element.value));
  return element;
}
