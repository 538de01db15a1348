// All around one drawing: the board, its tools, what the core says of it, and where it goes.
import { useState } from 'preact/hooks';
import type { MazeData } from '../core/types';
import { Button, Check } from '../ui/controls';
import { Field } from '../ui/field';
import { notesOn } from '../ui/format';
import { askForFiles } from '../ui/pick';
import type { Page } from '../page/page';
import { mazeText } from '../player/figures';
import { StageLooks } from '../player/looks';
import { BoardKeys, BoardRoom, createBoard } from './board';
import { createEditor, type Editor } from './editor';
import { createJudgement, JudgementCard } from './judgement';
import { Making } from './making';
import { Saving } from './saving';
import { Key } from './key';
import { createKeeper } from './storage';
import { Changes, Tools } from './tools';

export type Desk = ReturnType<typeof createDesk>;

const isEqual = (one: MazeData, other: MazeData) => JSON.stringify(one) === JSON.stringify(other);

/** Takes the maze of a file into the drawing; all else belongs to other views. */
async function openInto(page: Page, load: (maze: MazeData) => void, file: File) {
  const fileName = file.name;
  try {
    const content = new Uint8Array(await file.arrayBuffer());
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

/** `draw` is called after each change. */
export function createDesk(page: Page, first: MazeData, draw: () => void) {
  const editor = createEditor(first, () => changed());
  const board = createBoard(editor, draw);
  /** The shortest run, drawn where it is wanted. */
  const route = { isWanted: true, found: null as [number, number][] | null };
  function setRoute(changes: Partial<typeof route>) {
    Object.assign(route, changes);
    board.setRoute(route.isWanted ? route.found : null);
    draw();
  }
  const judgement = createJudgement(page, (answer) => setRoute({ found: answer?.route ?? null }));
  const keep = createKeeper(page);
  function load(maze: MazeData) {
    if (!isEqual(maze, editor.maze())) editor.change(maze);
    // The forms for a new one stand below it.
    board.reveal();
  }
  function changed() {
    const maze = editor.maze();
    board.show();
    judgement.judge(maze);
    keep(maze);
    draw();
  }
  return {
    page,
    editor,
    board,
    route,
    setRoute,
    judgement,
    /** Shows the drawing for the first time. */
    begin: changed,
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

/** What is typed is the name once it is done. */
function NameField({ editor }: { editor: Editor }) {
  const maze = editor.maze();
  const [typed, type] = useState<string | null>(null);
  return (
    <Field label="Name">
      <input
        type="text"
        maxLength={80}
        autocomplete="off"
        value={typed ?? maze.name}
        onInput={({ currentTarget }) => type(currentTarget.value)}
        onChange={({ currentTarget }) => editor.change({ ...maze, name: currentTarget.value.trim() || 'drawing' })}
        onBlur={() => type(null)}
      />
    </Field>
  );
}

function DrawingCard({ desk: { page, editor, route, setRoute } }: { desk: Desk }) {
  const maze = editor.maze();
  return (
    <section class="card" aria-label="Drawing">
      <h2 class="draw-title">{mazeText(maze)}</h2>
      <Key route={route.isWanted && route.found !== null} />
      <NameField editor={editor} />
      <Changes editor={editor} />
      <Check label="Shortest run" checked={route.isWanted} change={(isWanted) => setRoute({ isWanted })} />
      <Button label="Run a mouse here" class="main" act={() => page.live(maze)} />
      <BoardKeys />
    </section>
  );
}

export function DeskRoom({ desk }: { desk: Desk }) {
  const { page, editor, board, judgement, load } = desk;
  return (
    <div class="desk">
      <div class="desk-main">
        <Tools editor={editor} tool={board.tool()} choose={board.setTool}>
          <StageLooks stage={board.stage} />
        </Tools>
        <BoardRoom board={board} />
      </div>
      <div class="desk-panel">
        <div class="cards">
          <div>
            <DrawingCard desk={desk} />
            <Saving page={page} maze={editor.maze()} />
          </div>
          <div>
            <JudgementCard judgement={judgement} />
            <section class="card" aria-label="New drawing">
              <h2>New</h2>
              <Making page={page} made={load} />
              <span>
                <Button label="Open a file…" act={() => askForFiles(([file]) => void openInto(page, load, file))} />
              </span>
            </section>
          </div>
        </div>
      </div>
    </div>
  );
}
