// What the programs had to say at the end, and what is wrong with their records.
import { h } from '../ui/dom';
import type { Panel, State } from './state';

export function createWords(state: State): Panel {
  const element = h('section', { class: 'words' });
  let sides: unknown = null;
  return {
    element,
    update() {
      if (sides === state.sides) return;
      sides = state.sides;
      const speaking = state.sides.filter(({ track }) => track.play.last_words !== '');
      element.hidden = speaking.length === 0;
      element.replaceChildren(
        h('h3', {}, 'Last words'),
        ...speaking.map(({ track: { play } }) =>
          h(
            'div',
            {},
            h('p', { class: 'note' }, play.mouse),
            h('pre', { tabindex: 0, role: 'region', 'aria-label': `Last words of ${play.mouse}` }, play.last_words),
          ),
        ),
      );
    },
  };
}
