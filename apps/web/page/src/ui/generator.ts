// What a generator of mazes is asked for: its kind, the size, the seed, the share of loops.
import type { About, Named } from '../core/types';
import { h } from './dom';
import { complainAt, field } from './field';

export interface Order {
  generator: string;
  width: number;
  height: number;
  seed: number;
  loops: number;
}

/** `first` is chosen first; `more` are kinds beside those of the core. */
export function createGenerator(about: About, { first, more = [] }: { first: string; more?: Named[] }) {
  const kinds = [...about.generators, ...more];
  const kind = h('select', ...kinds.map(({ name }) => h('option', { value: name, selected: name === first }, name)));
  const summary = () => kinds.find(({ name }) => name === kind.value)?.summary ?? '';
  const whole = (value: number, min: number, max?: number) =>
    h('input', { type: 'number', inputmode: 'numeric', step: 1, min, max, value });
  const width = whole(16, 1, about.most_side);
  const height = whole(16, 1, about.most_side);
  const seed = whole(1, 0);
  const loops = h('input', { type: 'number', inputmode: 'decimal', step: 0.01, min: 0, max: 1, value: 0 });
  const help = h('span', summary());
  const fields = {
    generator: field('Kind', kind, help),
    width: field('Width', width),
    height: field('Height', height),
    seed: field('Seed', seed),
    loops: field('Loops', loops, h('span', 'share of the remaining walls to open, 0 to 1')),
  };
  const seeded = h('div.field-row', fields.seed, fields.loops);
  // What is deterministic needs no seed.
  const fit = () => {
    help.replaceChildren(summary());
    seeded.hidden = ['empty', ...more.map(({ name }) => name)].includes(kind.value);
  };
  kind.addEventListener('change', fit);
  fit();
  return {
    element: h('div.generator', fields.generator, h('div.field-row', fields.width, fields.height), seeded),
    order: () => ({
      generator: kind.value,
      width: width.valueAsNumber,
      height: height.valueAsNumber,
      seed: seeded.hidden ? 1 : seed.valueAsNumber,
      loops: seeded.hidden ? 0 : loops.valueAsNumber,
    }),
    /** Says what is wrong with the order, at its field where the message names one; nothing where it is empty. */
    complain: (message: string) => complainAt(fields, 'generator', message),
  };
}
