// The canvas that one draws on, by pointer and by keys.
import type { Cell } from '../core/types';
import { createStage, StageRoom, type Stage } from '../maze/stage';
import type { Editor } from './editor';
import { cellInWords, press } from './keys';
import { isInside } from './model';
import { nearestWall } from './nearest';
import { paintDrawing, type Overlay } from './painter';
import { beginStroke, drawn, type Stroke, type Tool } from './strokes';

export type Board = ReturnType<typeof createBoard>;

/** A finger hides what it touches: it may be farther away. */
const reachOf = (event: PointerEvent) => (event.pointerType === 'touch' ? 0.4 : 0.3);

const help =
  'Arrow keys move from cell to cell. W, A, S, D, or Shift with an arrow, close or open the wall on that side. ' +
  'G: goal. H: put the start here. R: turn the start. Z and X, or the wheel: nearer and farther. ' +
  'Ctrl+Z and Ctrl+Shift+Z: undo and redo.';

/** What draws, and where it is. */
interface Hand {
  tool: Tool | 'look';
  /** The cell of the keyboard. */
  cursor: Cell;
  /** What was just drawn is shown as it is, until the pointer leaves it. */
  fresh: string;
  stroke: { stroke: Stroke; at: [number, number]; pointer: number } | null;
  overlay: Overlay;
  /** Says what was done, or why it was not: to be read and to be heard. */
  say(words: string): void;
}

/** The place of the pointer, in cells. */
function placeOf({ canvas, geometry }: Stage, event: PointerEvent): [number, number] {
  const g = geometry();
  const box = canvas.getBoundingClientRect();
  const x = (event.clientX - box.left) * g.ratio;
  const y = (event.clientY - box.top) * g.ratio;
  return [(x - g.left) / g.pitch, g.height - (y - g.top) / g.pitch];
}

/** Shows the wall that the pointer would draw; null where it is elsewhere. */
function hover(editor: Editor, stage: Stage, hand: Hand, event: PointerEvent | null) {
  const { tool } = hand;
  const points = event && tool === 'walls' && event.pointerType !== 'touch';
  const wall = points ? nearestWall(editor.maze(), ...placeOf(stage, event)) : null;
  stage.canvas.style.cursor = tool === 'look' ? '' : wall || tool !== 'walls' ? 'crosshair' : 'default';
  if (JSON.stringify(wall) !== hand.fresh) hand.fresh = '';
  hand.overlay.hover = hand.fresh ? null : wall;
  stage.redraw();
}

function listenToPointer(editor: Editor, stage: Stage, hand: Hand) {
  const { canvas } = stage;
  function down(event: PointerEvent) {
    const { tool } = hand;
    if (event.button !== 0 || hand.stroke || tool === 'look') return;
    const at = placeOf(stage, event);
    const stroke = beginStroke(tool, editor.maze(), ...at, reachOf(event));
    if (!stroke) return;
    hand.stroke = { stroke, at, pointer: event.pointerId };
    canvas.setPointerCapture(event.pointerId);
    hand.overlay.hover = null;
    hand.say('');
    const next = stroke(editor.maze(), ...at);
    if (next === editor.maze() && tool === 'goals') hand.say('a maze must have at least one goal');
    editor.sketch(next);
  }
  function move(event: PointerEvent) {
    const { stroke } = hand;
    if (!stroke) return hover(editor, stage, hand, event);
    if (event.pointerId !== stroke.pointer) return;
    const to = placeOf(stage, event);
    const next = drawn(stroke.stroke, editor.maze(), stroke.at, to);
    stroke.at = to;
    if (next !== editor.maze()) editor.sketch(next);
  }
  function up(event: PointerEvent) {
    if (event.pointerId !== hand.stroke?.pointer) return;
    hand.stroke = null;
    if (event.type === 'pointercancel') editor.undo();
    else editor.settle();
    hand.fresh = JSON.stringify(nearestWall(editor.maze(), ...placeOf(stage, event)));
    hover(editor, stage, hand, event.type === 'pointerup' ? event : null);
  }
  canvas.addEventListener('pointerdown', down);
  canvas.addEventListener('pointermove', move);
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('pointerleave', () => hover(editor, stage, hand, null));
}

/** Brings the cell of the keyboard into sight, in a closer look. */
function keepInSight({ camera, geometry, look }: Stage, [column, row]: Cell) {
  const { scale, x, y } = camera();
  const { canvasWidth, canvasHeight, pitch } = geometry();
  const near = (place: number, middle: number, room: number) => {
    const reach = Math.max(0.5, room / pitch / 2 - 1);
    return Math.min(Math.max(middle, place + 0.5 - reach), place + 0.5 + reach);
  };
  if (scale > 1) look({ scale, x: near(column, x, canvasWidth), y: near(row, y, canvasHeight) });
}

function listenToKeys(editor: Editor, stage: Stage, hand: Hand) {
  const { canvas } = stage;
  const { overlay, say } = hand;
  function looks(event: KeyboardEvent) {
    const factor = { z: 1.4, x: 1 / 1.4 }[event.key.toLowerCase()];
    if (!factor || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    stage.zoomBy(factor);
    keepInSight(stage, hand.cursor);
  }
  canvas.addEventListener('keydown', (event) => {
    const pressed = hand.stroke ? null : press(event, editor.maze(), hand.cursor);
    if (!pressed) return looks(event);
    event.preventDefault();
    hand.cursor = overlay.cursor = pressed.cursor;
    keepInSight(stage, hand.cursor);
    editor.change(pressed.maze);
    say(pressed.said);
    stage.redraw();
  });
  canvas.addEventListener('focus', () => {
    if (!canvas.matches(':focus-visible')) return;
    overlay.cursor = hand.cursor;
    say(cellInWords(editor.maze(), hand.cursor));
    stage.redraw();
  });
  canvas.addEventListener('blur', () => {
    overlay.cursor = null;
    stage.redraw();
  });
}

/** The stage that shows the drawing. */
function createBoardStage(editor: Editor, hand: Hand): Stage {
  const stage = createStage(
    editor.maze(),
    (context, geometry, palette) => paintDrawing(context, geometry, palette, editor.maze(), hand.overlay),
    {
      numbers: true,
      // What draws does not pull the maze along: the middle button does, and the hand.
      mayDrag: ({ button }) => stage.camera().scale > 1 && (button === 1 || hand.tool === 'look'),
      twoFingers: () => {
        if (hand.stroke) editor.undo();
        hand.stroke = null;
      },
    },
  );
  const { canvas } = stage;
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-describedby', 'draw-keys');
  canvas.tabIndex = 0;
  listenToPointer(editor, stage, hand);
  listenToKeys(editor, stage, hand);
  return stage;
}

/** `draw` is called where something else is said, or another tool chosen. */
export function createBoard(editor: Editor, draw: () => void) {
  let said = '';
  const overlay: Overlay = { hover: null, cursor: null, route: null };
  function say(words: string) {
    if (words === said) return;
    said = words;
    draw();
  }
  const hand: Hand = { tool: 'walls', cursor: editor.maze().start, fresh: '', stroke: null, overlay, say };
  let size = '';
  const stage = createBoardStage(editor, hand);
  const { canvas } = stage;

  function show() {
    const maze = editor.maze();
    if (!isInside(maze, hand.cursor)) hand.cursor = maze.start;
    if (overlay.cursor) overlay.cursor = hand.cursor;
    stage.describe(`Drawing of ${maze.width} by ${maze.height} cells`);
    if (size === `${maze.width}x${maze.height}`) return stage.redraw();
    size = `${maze.width}x${maze.height}`;
    overlay.hover = null;
    stage.resize(maze);
  }
  return {
    stage,
    said: () => said,
    /** Shows the drawing as it is now. */
    show,
    tool: () => hand.tool,
    /** What the pointer draws; or that it looks around. */
    setTool(next: Tool | 'look') {
      hand.tool = next;
      canvas.classList.toggle('looking', next === 'look');
      hover(editor, stage, hand, null);
      draw();
    },
    setRoute(route: Cell[] | null) {
      overlay.route = route;
      stage.redraw();
    },
    /** Scrolls to it, where it is out of sight. */
    reveal: () => canvas.parentElement?.scrollIntoView({ block: 'nearest' }),
  };
}

export const BoardRoom = ({ board: { stage, said } }: { board: Board }) => (
  <div class="draw-board">
    <StageRoom stage={stage} />
    <p class="draw-said" aria-live="polite">
      {said()}
    </p>
  </div>
);

/** Which keys there are. */
export const BoardKeys = () => (
  <p class="draw-keys" id="draw-keys">
    {help}
  </p>
);
