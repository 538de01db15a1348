// What a program printed, step by step, beside the replay of its contest.
import { h } from '../ui/dom';
import type { Print } from './contest';

export interface Prints extends HTMLElement {
  show(prints: Print[]): void;
  update(time: number): void;
}

/** `go` leads the replay to a frame. */
export function createPrints(go: (frame: number) => void): Prints {
  const list = h('ol', { tabindex: 0, 'aria-label': 'What it printed, by step' });
  const element = h('section.prints', { 'aria-label': 'Prints', hidden: true }, h('h3', 'Prints'), list);
  let shown: { frame: number; item: HTMLElement }[] = [];
  let marked: HTMLElement | null = null;
  return Object.assign(element, {
    show(prints: Print[]) {
      marked = null;
      shown = prints.map(({ frame, text }) => ({
        frame,
        item: h(
          'li',
          h('button', { type: 'button', onclick: () => go(frame) }, `step ${frame + 1}`),
          h('pre', text.replace(/\n$/, '')),
        ),
      }));
      list.replaceChildren(...shown.map(({ item }) => item));
      element.hidden = shown.length === 0;
    },
    /** Marks what was printed last at that time. */
    update(time: number) {
      const now = shown.filter(({ frame }) => frame <= time).at(-1)?.item ?? null;
      if (now === marked) return;
      marked?.removeAttribute('aria-current');
      now?.setAttribute('aria-current', 'step');
      marked = now;
      if (now) list.scrollTop = now.offsetTop - list.offsetTop - list.clientHeight / 2;
    },
  });
}
