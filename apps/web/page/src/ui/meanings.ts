// What the terms of a list or a table mean, to be read where they stand: a title needs a pointer.
import { h } from './dom';

/** Folded away; `of` are terms with their meanings, those without one are left out. */
export const meanings = (of: [term: string, meaning: string | undefined][]): HTMLElement =>
  h(
    'details',
    { class: 'meanings controls' },
    h('summary', {}, 'What they mean'),
    h('dl', {}, ...of.flatMap(([term, meaning]) => (meaning ? [h('dt', {}, term), h('dd', {}, meaning)] : []))),
  );
