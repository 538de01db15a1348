// A mouse with its parameters as a text: `certify:home=yes`, as the command line takes it.
import type { Mouse } from '../core/types';

/** Parameters that were given a value, as text; null for a setting without `=`, which stays as it was written. */
export type Values = Record<string, string | null>;

export interface Spec {
  mouse: string;
  values: Values;
}

/** The SPEC: values that are not the default in the order of the mouse's table, then those that it does not have. */
export function specOf(mouse: string, values: Values, mice: Mouse[]): string {
  const table = mice.find((one) => one.name === mouse)?.parameters ?? [];
  const setting = (name: string) => (values[name] === null ? name : `${name}=${values[name]}`);
  const parts = table
    .filter(({ name, default: usual }) => name in values && values[name] !== usual)
    .map(({ name }) => setting(name));
  const others = Object.keys(values).filter((name) => !table.some((parameter) => parameter.name === name));
  return [mouse, ...parts, ...others.map(setting)].join(':');
}

/** What a SPEC says, without a look at whether it is right: that is the core's to say. */
export function readSpec(spec: string): Spec {
  const [mouse, ...settings] = spec.trim().split(':');
  const values: Values = Object.create(null);
  for (const setting of settings) {
    const equals = setting.indexOf('=');
    if (equals > 0) values[setting.slice(0, equals).trim()] = setting.slice(equals + 1).trim();
    else values[setting] = null;
  }
  return { mouse, values };
}

/** The value of a parameter: what was given, or its default. */
export const valueOf = (parameter: { name: string; default: string }, values: Values) =>
  parameter.name in values ? (values[parameter.name] ?? '') : parameter.default;
