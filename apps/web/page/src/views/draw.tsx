import type { MazeData } from '../core/types';
import { createDesk, DeskRoom, type Desk } from '../draw/desk';
import { restoreDrawing } from '../draw/storage';
import { addressOf, readAddress } from '../link/address';
import { mazeAt, placeOf } from '../link/mazes';
import { isMaze } from '../maze/same';
import { createRoot } from '../ui/root';
import type { Page, View } from '../page/page';
import '../styles/forms.css';
import '../styles/draw.css';

/** Draw, and what is drawn in it: null before there is a drawing. */
export interface DrawView extends View {
  maze(): MazeData | null;
}

const isText = (target: EventTarget | null) =>
  target instanceof HTMLElement && target.matches('input:not([type=radio]):not([type=checkbox]), textarea');

async function emptyDrawing(page: Page): Promise<MazeData> {
  const order = { generator: 'empty', width: 16, height: 16, seed: 1, loops: 0 };
  return { ...(await page.core.call('make_maze', order)).maze, name: 'drawing' };
}

/** The view Draw. It accepts mazes; each is a step that can be undone. */
export function createDraw(page: Page): DrawView {
  const { element, draw } = createRoot('draw', 'Draw', () => desk && <DeskRoom desk={desk} />);
  let desk: Desk | null = null;
  /** As long as it is empty, nobody has drawn anything. */
  let empty: MazeData | null = null;
  async function start() {
    const drawing = (await restoreDrawing(page)) ?? (empty = await emptyDrawing(page));
    desk = createDesk(page, drawing, draw);
    desk.begin();
  }
  const ready = start();
  ready.catch(page.complain);
  document.addEventListener('keydown', (event) => {
    if (!element.hidden && !isText(event.target) && desk?.key(event)) event.preventDefault();
  });
  return {
    element,
    maze() {
      const drawing = desk?.drawing() ?? null;
      return drawing === empty ? null : drawing;
    },
    shown() {},
    accept(thing) {
      if (isMaze(thing)) void ready.then(() => desk?.load(thing));
    },
    async address() {
      await ready;
      const { drawing, look } = desk!;
      return addressOf('draw', { ...(await placeOf(page.core, page.about, drawing())), look: look() });
    },
    async follow(hash) {
      const { moment } = readAddress(hash);
      const maze = await mazeAt(page.core, moment);
      await ready;
      if (maze) desk!.load(maze);
      if (moment.look) desk!.lookFrom(moment.look);
    },
  };
}
