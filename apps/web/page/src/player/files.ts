// What can be done with the contests that are shown: saved, printed, opened elsewhere.
import { h } from '../ui/dom';
import type { Page } from '../views/view';
import { createPictures, fileName } from './pictures';
import type { Panel, Side, State } from './state';

async function savePicture(page: Page, side: Side) {
  try {
    const { svg } = await page.core.call('picture', {}, new TextEncoder().encode(side.record));
    page.save(fileName([side], 'svg'), svg, 'image/svg+xml');
  } catch (error) {
    page.complain(error);
  }
}

export function createFiles(page: Page, state: State): Panel {
  const chosen = () => state.sides[state.chosen];
  const button = (label: string, onclick: () => void) => h('button', { type: 'button', onclick }, label);
  const save = button('Save record', () => page.save(fileName([chosen()], 'jsonl'), chosen().record));
  const picture = button('Save whole walk (SVG)', () => void savePicture(page, chosen()));
  const pictures = createPictures(page, state);
  return {
    element: h(
      'div',
      { class: 'files', role: 'group', 'aria-label': 'Save and open' },
      save,
      picture,
      ...pictures.buttons,
      button('Run in Live', () => page.live(chosen().track.maze)),
      button('Open in Draw', () => page.draw(chosen().track.maze)),
      button('Print', () => print()),
      pictures.progress,
    ),
    update() {
      save.disabled = chosen().record === '';
      picture.disabled = chosen().record === '' || chosen().track.play.world === 'mms';
    },
  };
}
