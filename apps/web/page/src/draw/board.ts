// The canvas that one draws on, by pointer and by keys.
import type { Cell } from '../core/types';
import { createStage, type Stage } from '../maze/stage';
import { h } from '../ui/dom';
import type { Editor } from './editor';
import { cellInWords, press } from './keys';
import { isInside } from './model';
import { nearestWall } from './nearest';
import { paintDrawing, type Overlay } from './painter';
import { beginStroke, drawn, type Stroke, type Tool } from './strokes';

export interface Board {
  element: HTMLElement;
  stage: Stage;
  /** Which keys there are. */
  keys: HTMLElement;
  /** Shows the drawing as it is now. */
  show(): void;
  /** What the pointer draws; or that it looks around. */
  setTool(tool: Tool | 'look'): void;
  setRoute(route: Cell[] | null): void;
  /** Scrolls to it, where it is out of sight. */
  reveal(): void;
}

/** A finger hides what it touches: it may be farther away. */
const reachOf = (event: PointerEvent) => (event.pointerType === 'touch' ? 0.4 : 0.3);

const help =
  'Arrow keys move from cell to cell. W, A, S, D, or Shift with an arrow, close or open the wall on that side. ' +
  'G: goal. H: put the start here. R: turn the start. Z and X, or the wheel: nearer and farther. ' +
  'Ctrl+Z and Ctrl+Shift+Z: undo and redo.';

export function createBoard(editor: Editor): Board {
  /** What was done, or why it was not: to be read and to be heard. */
  const said = h('p', { class: 'draw-said', 'aria-live': 'polite' });
  const say = (words: string) => said.textContent !== words && said.replaceChildren(words);
  const overlay: Overlay = { hover: null, cursor: null, route: null };
  let tool: Tool | 'look' = 'walls';
  let cursor: Cell = editor.maze().start;
  let size = '';
  /** What was just drawn is shown as it is, until the pointer leaves it. */
  let fresh = '';
  let stroke: { stroke: Stroke; at: [number, number]; pointer: number } | null = null;

  const stage = createStage(
    editor.maze(),
    (context, geometry, palette) => paintDrawing(context, geometry, palette, editor.maze(), overlay),
    {
      numbers: true,
      // What draws does not pull the maze along: the middle button does, and the hand.
      mayDrag: ({ button }) => stage.camera().scale > 1 && (button === 1 || tool === 'look'),
      twoFingers: () => {
        if (stroke) editor.undo();
        stroke = null;
      },
    },
  );
  const { canvas } = stage;
  const keys = h('p', { id: 'draw-keys', class: 'draw-keys' }, help);
  canvas.setAttribute('role', 'application');
  canvas.setAttribute('aria-describedby', 'draw-keys');
  canvas.tabIndex = 0;

  function place(event: PointerEvent): [number, number] {
    const g = stage.geometry();
    const box = canvas.getBoundingClientRect();
    const x = (event.clientX - box.left) * g.ratio;
    const y = (event.clientY - box.top) * g.ratio;
    return [(x - g.left) / g.pitch, g.height - (y - g.top) / g.pitch];
  }

  function hover(event: PointerEvent | null) {
    const wall =
      event && tool === 'walls' && event.pointerType !== 'touch' ? nearestWall(editor.maze(), ...place(event)) : null;
    canvas.style.cursor = tool === 'look' ? '' : wall || tool !== 'walls' ? 'crosshair' : 'default';
    if (JSON.stringify(wall) !== fresh) fresh = '';
    overlay.hover = fresh ? null : wall;
    stage.redraw();
  }

  function down(event: PointerEvent) {
    if (event.button !== 0 || stroke || tool === 'look') return;
    const at = place(event);
    const begun = beginStroke(tool, editor.maze(), ...at, reachOf(event));
    if (!begun) return;
    stroke = { stroke: begun, at, pointer: event.pointerId };
    canvas.setPointerCapture(event.pointerId);
    overlay.hover = null;
    say('');
    const next = begun(editor.maze(), ...at);
    if (next === editor.maze() && tool === 'goals') say('a maze must have at least one goal');
    editor.sketch(next);
  }

  function move(event: PointerEvent) {
    if (!stroke) return hover(event);
    if (event.pointerId !== stroke.pointer) return;
    const to = place(event);
    const next = drawn(stroke.stroke, editor.maze(), stroke.at, to);
    stroke.at = to;
    if (next !== editor.maze()) editor.sketch(next);
  }

  function up(event: PointerEvent) {
    if (event.pointerId !== stroke?.pointer) return;
    stroke = null;
    if (event.type === 'pointercancel') editor.undo();
    else editor.settle();
    fresh = JSON.stringify(nearestWall(editor.maze(), ...place(event)));
    hover(event.type === 'pointerup' ? event : null);
  }

  /** The cell of the keyboard, in a closer look. */
  function keepInSight() {
    const { scale, x, y } = stage.camera();
    const { canvasWidth, canvasHeight, pitch } = stage.geometry();
    const near = (place: number, middle: number, room: number) => {
      const reach = Math.max(0.5, room / pitch / 2 - 1);
      return Math.min(Math.max(middle, place + 0.5 - reach), place + 0.5 + reach);
    };
    if (scale > 1) stage.look({ scale, x: near(cursor[0], x, canvasWidth), y: near(cursor[1], y, canvasHeight) });
  }

  canvas.addEventListener('pointerdown', down);
  canvas.addEventListener('pointermove', move);
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('pointerleave', () => hover(null));
  function looks(event: KeyboardEvent) {
    const factor = { z: 1.4, x: 1 / 1.4 }[event.key.toLowerCase()];
    if (!factor || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    stage.zoomBy(factor);
    keepInSight();
  }
  canvas.addEventListener('keydown', (event) => {
    const pressed = stroke ? null : press(event, editor.maze(), cursor);
    if (!pressed) return looks(event);
    event.preventDefault();
    cursor = overlay.cursor = pressed.cursor;
    keepInSight();
    editor.change(pressed.maze);
    say(pressed.said);
    stage.redraw();
  });
  canvas.addEventListener('focus', () => {
    if (!canvas.matches(':focus-visible')) return;
    overlay.cursor = cursor;
    say(cellInWords(editor.maze(), cursor));
    stage.redraw();
  });
  canvas.addEventListener('blur', () => {
    overlay.cursor = null;
    stage.redraw();
  });

  function show() {
    const maze = editor.maze();
    if (!isInside(maze, cursor)) cursor = maze.start;
    if (overlay.cursor) overlay.cursor = cursor;
    stage.describe(`Drawing of ${maze.width} by ${maze.height} cells`);
    if (size === `${maze.width}x${maze.height}`) return stage.redraw();
    size = `${maze.width}x${maze.height}`;
    overlay.hover = null;
    stage.resize(maze);
  }
  return {
    element: h('div', { class: 'draw-board' }, stage.element, said),
    stage,
    keys,
    show,
    setTool(next) {
      tool = next;
      canvas.classList.toggle('looking', tool === 'look');
      hover(null);
    },
    setRoute(route) {
      overlay.route = route;
      stage.redraw();
    },
    reveal: () => stage.element.scrollIntoView({ block: 'nearest' }),
  };
}
