// A mouse of ours beside the contest that is shown, under its conditions.
import type { Play } from '../core/types';
import { h } from '../ui/dom';
import type { Page } from '../page/page';
import type { Shown } from '../player/side';

export type Beside = ReturnType<typeof createBeside>;

const usual = 'ariadne';

/** The same contest held by that mouse. */
const holdAgain = (page: Page, { maze, seed, again }: Play, mouse: string): Promise<Shown> =>
  page.core.call('contest', { ...again!.with, mouse, maze, seed: seed ?? 1 });

/** `shown` hears of both plays. */
export function createBeside(page: Page, shown: (plays: Shown[]) => void) {
  const select = h('select');
  let first: Shown | null = null;
  async function play() {
    const one = first;
    if (!one) return;
    button.disabled = true;
    try {
      const other = await holdAgain(page, one.play, select.value);
      if (one === first) shown([one, other]);
    } catch (error) {
      page.complain(error);
    } finally {
      button.disabled = false;
    }
  }
  const button = h('button', { type: 'button', onclick: () => void play() }, 'Play it');
  const element = h('p.beside.row', { hidden: true }, h('label', 'Beside it: ', select), button);
  return {
    element,
    /** What is shown now; nothing is offered beside two. */
    show(plays: Shown[]) {
      const again = plays[0]?.play.again;
      element.hidden = plays.length !== 1 || !again;
      first = element.hidden ? null : plays[0];
      if (!first || !again) return;
      const before = select.value || usual;
      select.replaceChildren(...again.mice.map((name) => h('option', { value: name }, name)));
      if (again.mice.includes(before)) select.value = before;
    },
  };
}
