// The first minute: what this is, and a mouse at work.
import { h } from '../ui/dom';
import type { EarlyPage } from '../views/view';

const mouse = 'ariadne';

/** Replays a mouse in a maze of the usual size. */
async function showMouse(page: EarlyPage) {
  const { mazes } = await page.ready;
  const { name } = mazes.find(({ width }) => width === 16) ?? mazes[0];
  page.tell(`${mouse} in ${name} …`);
  try {
    const { maze } = await page.core.call('builtin_maze', { name });
    const play = await page.core.call('run', { mouse, maze, seed: 1 });
    page.tell('');
    page.replay([play]);
  } catch (error) {
    page.tell('');
    page.complain(error);
  }
}

export function welcome(page: EarlyPage): HTMLElement {
  const see = h('button', { type: 'button', class: 'main', disabled: true }, 'See a mouse run');
  see.addEventListener('click', () => void showMouse(page));
  page.ready.then(
    () => (see.disabled = false),
    () => see.remove(),
  );
  return h(
    'div',
    { class: 'row' },
    h(
      'p',
      {},
      'labmouse is a laboratory for mice: programs that find their way through a maze they have never seen, then run it fast.',
    ),
    see,
  );
}
