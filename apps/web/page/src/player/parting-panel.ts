// Says of two mice in one maze where they part, and leads there.
import { isSameMaze } from '../maze/same';
import { h } from '../ui/dom';
import { partingOf, type Parting } from './parting';
import type { Actions, Panel, Side, State } from './state';

/** Whether the steps of both mean the same. */
const isComparable = ([one, other]: Side[]) =>
  one.track.play.world === other.track.play.world && isSameMaze(one.track.play, other.track.play);

const does = ({ name }: Side, action: string | null) => (action === null ? `${name} has ended` : `${name}: ${action}`);

function wordsOf([one, other]: Side[], { frame, cell, actions }: Parting) {
  const where = `step ${frame + 1}, in cell (${cell[0]},${cell[1]})`;
  return `They part at ${where}. ${does(one, actions[0])}; ${does(other, actions[1])}.`;
}

export function createParting(state: State, actions: Actions): Panel {
  const words = h('span', {});
  const go = h('button', { type: 'button', onclick: () => actions.seek(time) }, 'Go there');
  const element = h('p', { class: 'parting', hidden: true }, words, ' ', go);
  let shown: Side[] = [];
  let time = 0;

  return {
    element,
    update() {
      const { sides } = state;
      if (sides === shown) return;
      shown = sides;
      element.hidden = sides.length < 2 || !isComparable(sides);
      if (element.hidden) return;
      const parting = partingOf(sides[0].track.play, sides[1].track.play);
      go.hidden = parting === null;
      words.replaceChildren(parting ? wordsOf(sides, parting) : 'Both go the same way, step by step.');
      if (parting) time = Math.max(...sides.map(({ track }) => track.time[Math.min(parting.frame, track.last)]));
    },
  };
}
