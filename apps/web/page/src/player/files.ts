// What can be done with the contests that are shown: saved, printed, opened elsewhere.
import { h } from '../ui/dom';
import type { Page } from '../views/view';
import type { Panel, Side, State } from './state';

/** Letters, digits, - and _ of mouse and maze, for a file's name. */
function fileName({ track }: Side, ending: string): string {
  const plain = (text: string) =>
    text
      .replace(/[^\w-]+/g, '-')
      .replace(/^-+|-+$/g, '')
      .slice(0, 60);
  return `${plain(track.play.mouse)}-${plain(track.maze.name)}.${ending}`;
}

async function savePicture(page: Page, side: Side) {
  try {
    const { svg } = await page.core.call('picture', {}, new TextEncoder().encode(side.record));
    page.save(fileName(side, 'svg'), svg, 'image/svg+xml');
  } catch (error) {
    page.complain(error);
  }
}

export function createFiles(page: Page, state: State): Panel {
  const chosen = () => state.sides[state.chosen];
  const button = (label: string, onclick: () => void) => h('button', { type: 'button', onclick }, label);
  const save = button('Save record', () => page.save(fileName(chosen(), 'jsonl'), chosen().record));
  const picture = button('Save picture', () => void savePicture(page, chosen()));
  return {
    element: h(
      'div',
      { class: 'files', role: 'group', 'aria-label': 'Save and open' },
      save,
      picture,
      button('Run in Live', () => page.live(chosen().track.maze)),
      button('Open in Draw', () => page.draw(chosen().track.maze)),
      button('Print', () => print()),
    ),
    update() {
      save.disabled = chosen().record === '';
      picture.disabled = chosen().record === '' || chosen().track.play.world === 'mms';
    },
  };
}
