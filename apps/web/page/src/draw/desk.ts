// All around one drawing: the board, its tools, what the core says of it, and where it goes.
import type { MazeData } from '../core/types';
import type { Camera } from '../maze/camera';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import { filePicker } from '../ui/pick';
import type { Page } from '../page/page';
import { mazeText } from '../player/figures';
import { createLooks } from '../player/looks';
import { createBoard } from './board';
import { createEditor } from './editor';
import { createJudgement } from './judgement';
import { createMaking } from './making';
import { createSaving } from './saving';
import { createKey } from './key';
import { createKeeper } from './storage';
import { createTools } from './tools';

export interface Desk {
  element: HTMLElement;
  drawing(): MazeData;
  /** Where one looks at it from. */
  look(): Camera;
  lookFrom(camera: Camera): void;
  /** Another maze in place of the drawing, as a step that can be undone. */
  load(maze: MazeData): void;
  /** A key that was pressed anywhere in the view; true where it was for the desk. */
  key(event: KeyboardEvent): boolean;
}

const isEqual = (one: MazeData, other: MazeData) => JSON.stringify(one) === JSON.stringify(other);

export function createDesk(page: Page, first: MazeData): Desk {
  const editor = createEditor(first, () => changed());
  const board = createBoard(editor);
  const room = h('div', { class: 'desk' });
  const tools = createTools(editor, board.setTool, createLooks(board.stage, room));
  const withRoute = h('input', { type: 'checkbox', checked: true, onchange: () => showRoute() });
  let found: [number, number][] | null = null;
  const showRoute = () => {
    board.setRoute(withRoute.checked ? found : null);
    key.setRoute(withRoute.checked && found !== null);
  };
  const judgement = createJudgement(page, (answer) => {
    found = answer?.route ?? null;
    showRoute();
  });
  const saving = createSaving(page, editor.maze);
  const keep = createKeeper(page);
  const name = h('input', { type: 'text', maxlength: 80, autocomplete: 'off' });
  name.addEventListener('change', () => editor.change({ ...editor.maze(), name: name.value.trim() || 'drawing' }));

  const title = h('h2', { class: 'draw-title' });
  const key = createKey();

  function load(maze: MazeData) {
    if (!isEqual(maze, editor.maze())) editor.change(maze);
    // The forms for a new one stand below it.
    board.reveal();
  }
  async function open(fileName: string, content: Uint8Array) {
    try {
      const opened = await page.core.call('open', { name: fileName }, content);
      if (opened.kind === 'results')
        return page.tell(`${fileName} holds the results of a race; drop it on the page instead.`);
      if (opened.kind === 'robot') return page.tell(`${fileName} is a robot; drop it on the page instead.`);
      load(opened.kind === 'maze' ? opened.maze : opened.play.maze);
      page.tell(`${fileName} is open; undo restores the previous drawing.`);
    } catch (error) {
      page.complain(error);
    }
  }
  function changed() {
    const maze = editor.maze();
    title.replaceChildren(mazeText(maze));
    board.show();
    tools.show();
    saving.changed();
    judgement.judge(maze);
    keep(maze);
    if (document.activeElement !== name) name.value = maze.name;
  }
  changed();

  const drawn = [
    h(
      'section',
      { class: 'card', 'aria-label': 'Drawing' },
      title,
      key.element,
      field('Name', name),
      tools.changes,
      h('label', { class: 'check' }, withRoute, 'Shortest run'),
      h('button', { type: 'button', class: 'main', onclick: () => page.live(editor.maze()) }, 'Run a mouse here'),
      board.keys,
    ),
    saving.element,
  ];
  const judged = [
    judgement.element,
    h(
      'section',
      { class: 'card', 'aria-label': 'New drawing' },
      h('h2', {}, 'New'),
      createMaking(page, load),
      filePicker('Open a file…', open),
    ),
  ];
  room.append(
    h('div', { class: 'desk-main' }, tools.element, board.element),
    h('div', { class: 'desk-panel' }, h('div', { class: 'cards' }, h('div', {}, ...drawn), h('div', {}, ...judged))),
  );
  return {
    element: room,
    drawing: editor.maze,
    look: board.stage.camera,
    lookFrom: board.stage.look,
    load,
    key(event) {
      if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
      const letter = event.key.toLowerCase();
      if (letter !== 'z' && letter !== 'y') return false;
      if (letter === 'y' || event.shiftKey) editor.redo();
      else editor.undo();
      return true;
    },
  };
}
