// All around one drawing: the board, its tools, what the core says of it, and where it goes.
import type { MazeData } from '../core/types';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import { notesOn } from '../ui/format';
import { filePicker } from '../ui/pick';
import type { Page } from '../page/page';
import { mazeText } from '../player/figures';
import { createLooks } from '../player/looks';
import { createBoard, type Board } from './board';
import { createEditor, type Editor } from './editor';
import { createJudgement } from './judgement';
import { createMaking } from './making';
import { createSaving } from './saving';
import { createKey, type Key } from './key';
import { createKeeper } from './storage';
import { createTools } from './tools';

export type Desk = ReturnType<typeof createDesk>;

const isEqual = (one: MazeData, other: MazeData) => JSON.stringify(one) === JSON.stringify(other);

/** Takes the maze of a file into the drawing; all else belongs to other views. */
async function openInto(page: Page, load: (maze: MazeData) => void, fileName: string, content: Uint8Array) {
  try {
    const opened = await page.core.call('open', { name: fileName }, content);
    if (opened.kind === 'results')
      return page.tell(`${fileName} holds the results of a race; drop it on the page instead.`);
    if (opened.kind === 'robot') return page.tell(`${fileName} is a robot; drop it on the page instead.`);
    load(opened.kind === 'maze' ? opened.maze : opened.play.maze);
    const notes = opened.kind === 'maze' ? notesOn(fileName, opened.notes) : [];
    page.tell([`${fileName} is open; undo restores the previous drawing.`, ...notes].join(' '));
  } catch (error) {
    page.complain(error);
  }
}

/** The keys of undo and redo; true where it was one of them. */
function undoes(event: KeyboardEvent, editor: Editor): boolean {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  const letter = event.key.toLowerCase();
  if (letter !== 'z' && letter !== 'y') return false;
  if (letter === 'y' || event.shiftKey) editor.redo();
  else editor.undo();
  return true;
}

/** The shortest run, drawn where it is wanted. */
function createRoute(board: Board, key: Key) {
  let found: [number, number][] | null = null;
  const wanted = h('input', { type: 'checkbox', checked: true, onchange: show });
  function show() {
    board.setRoute(wanted.checked ? found : null);
    key.setRoute(wanted.checked && found !== null);
  }
  return {
    element: h('label.check', wanted, 'Shortest run'),
    take(route: [number, number][] | null) {
      found = route;
      show();
    },
  };
}

const card = (label: string, ...content: HTMLElement[]) => h('section.card', { 'aria-label': label }, ...content);

export function createDesk(page: Page, first: MazeData) {
  const editor = createEditor(first, () => changed());
  const board = createBoard(editor);
  const room = h('div.desk');
  const tools = createTools(editor, board.setTool, createLooks(board.stage, room));
  const key = createKey();
  const route = createRoute(board, key);
  const judgement = createJudgement(page, (answer) => route.take(answer?.route ?? null));
  const saving = createSaving(page, editor.maze);
  const keep = createKeeper(page);
  const name = h('input', { type: 'text', maxlength: 80, autocomplete: 'off' });
  name.addEventListener('change', () => editor.change({ ...editor.maze(), name: name.value.trim() || 'drawing' }));
  const title = h('h2.draw-title');

  function load(maze: MazeData) {
    if (!isEqual(maze, editor.maze())) editor.change(maze);
    // The forms for a new one stand below it.
    board.reveal();
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
  const run = button('Run a mouse here', () => page.live(editor.maze()), { class: 'main' });
  const drawing = [title, key.element, field('Name', name), tools.changes, route.element, run, board.keys];
  const opener = filePicker('Open a file…', (fileName, content) => void openInto(page, load, fileName, content));
  const made = card('New drawing', h('h2', 'New'), createMaking(page, load), opener);
  const drawn = h('div', card('Drawing', ...drawing), saving.element);
  room.append(
    h('div.desk-main', tools.element, board.element),
    h('div.desk-panel', h('div.cards', drawn, h('div', judgement.element, made))),
  );
  return {
    element: room,
    drawing: editor.maze,
    /** Where one looks at it from. */
    look: board.stage.camera,
    lookFrom: board.stage.look,
    /** Another maze in place of the drawing, as a step that can be undone. */
    load,
    /** A key that was pressed anywhere in the view; true where it was for the desk. */
    key: (event: KeyboardEvent) => undoes(event, editor),
  };
}
