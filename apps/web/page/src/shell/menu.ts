// What is wanted now and then, behind three dots: what the browser keeps, and on narrow screens all tools of the header.
import { h } from '../ui/dom';
import type { Notices } from './notices';
import type { Shelf } from '../page/shelf';

/** As the style sheet has it. */
const narrow = '(max-width: 40rem)';

/** `tools` stand beside the dots where there is room for them. */
export function createMenu(tools: HTMLElement[], shelf: Shelf, notices: Notices): HTMLElement {
  const keeps = h('input', { type: 'checkbox', checked: shelf.keeps() });
  keeps.addEventListener('change', async () => {
    await shelf.setKeeps(keeps.checked);
    notices.tell(
      keeps.checked ? 'What is open is kept from now on.' : 'Nothing is kept any more, and what was is gone.',
    );
  });
  const empty = h('button', { type: 'button' }, 'Forget what was kept');
  empty.addEventListener('click', async () => {
    await shelf.empty();
    notices.tell('What was kept is gone.');
    menu.open = false;
  });
  const room = h('div.menu-tools');
  const menu = h(
    'details.menu',
    h('summary', { 'aria-label': 'More', title: 'More' }, h('span', { 'aria-hidden': 'true' }, '⋯')),
    h(
      'div.menu-box',
      room,
      h('label.check', keeps, 'Keep what is open for the next time'),
      h('p.note', 'In this browser alone: mazes, records, results, robots, programs and the drawing.'),
      empty,
    ),
  );
  const element = h('div.tools', menu);
  const media = matchMedia(narrow);
  const arrange = () => (media.matches ? room.append(...tools) : menu.before(...tools));
  media.addEventListener('change', arrange);
  arrange();

  document.addEventListener('pointerdown', ({ target }) => {
    if (menu.open && target instanceof Node && !menu.contains(target)) menu.open = false;
  });
  // What was chosen in it is done; a choice that stays open is not.
  room.addEventListener('click', ({ target }) => {
    if (target instanceof Element && target.closest('button')) menu.open = false;
  });
  menu.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !menu.open) return;
    menu.open = false;
    menu.querySelector('summary')?.focus();
    event.stopPropagation();
  });
  return element;
}
