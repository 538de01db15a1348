// A labelled control, with a line of help and room for what is wrong with it.
import { h } from './dom';

let fields = 0;

export interface Field extends HTMLElement {
  /** Says what is wrong with the value, in sight; nothing where that is empty. */
  complain(message: string): void;
}

/** Brings an error into sight, unless somebody is writing elsewhere and would lose the place. */
export function showError(error: HTMLElement) {
  if (!document.activeElement?.matches('input, select, textarea, [contenteditable]'))
    error.scrollIntoView({ block: 'nearest' });
}

/** `help` stands below the control and describes it. */
export function field(label: string, control: HTMLElement, help?: HTMLElement): Field {
  const id = `field-${++fields}`;
  control.id ||= id;
  const error = h('span.field-error', { id: `${id}-error`, role: 'alert' });
  if (help) help.id = `${id}-help`;
  help?.classList.add('field-help');
  control.setAttribute('aria-describedby', `${help ? `${id}-help ` : ''}${id}-error`);
  const element = h('div.field', h('label', { for: control.id }, label), control, help, error);
  return Object.assign(element, {
    complain(message: string) {
      const isNew = error.textContent !== message;
      if (isNew) error.replaceChildren(message);
      if (isNew && message) showError(element);
      if (message) control.setAttribute('aria-invalid', 'true');
      else control.removeAttribute('aria-invalid');
    },
  });
}

/**
 * Says a message of the core at the field that it names in quotes ("'budget' is outside the range 1 to 1000000"), or else at
 * `usual`; all others are quiet then.
 */
export function complainAt<Name extends string>(
  fields: Record<Name, Pick<Field, 'complain'>>,
  usual: NoInfer<Name>,
  message: string,
) {
  const names = Object.keys(fields) as Name[];
  const named = names.find((name) => message.includes(`'${name}'`)) ?? usual;
  for (const name of names) fields[name].complain(name === named ? message : '');
}
