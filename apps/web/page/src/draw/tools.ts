// The tools above the drawing: what the pointer draws, back and forth, and changes of the whole.
import type { MazeData } from '../core/types';
import { icon, type IconName } from '../player/icons';
import { h } from '../ui/dom';
import type { Editor } from './editor';
import { mirrored, rotated, withTurnedStart } from './model';
import type { Tool } from './strokes';

const tools: { tool: Tool | 'look'; label: string; title: string }[] = [
  { tool: 'walls', label: 'Walls', title: 'Click or drag along walls; drag the start and the goals' },
  { tool: 'goals', label: 'Goals', title: 'Click or drag over cells to make them goals or not' },
  { tool: 'start', label: 'Start', title: 'Click the cell where mice start' },
  {
    tool: 'look',
    label: 'Look',
    title: 'Drag to look around, once you are near; on a touch screen this scrolls the page',
  },
];

export function createTools(editor: Editor, choose: (tool: Tool | 'look') => void, looks: HTMLElement) {
  const radios = tools.map(({ tool, label, title }, i) =>
    h(
      'label',
      { title },
      h('input', { type: 'radio', name: 'draw-tool', value: tool, checked: i === 0, onchange: () => choose(tool) }),
      h('span', label),
    ),
  );
  const button = (label: string, title: string, onclick: () => void) =>
    h('button', { type: 'button', title, onclick }, label);
  const sign = (name: IconName, label: string, keys: string, onclick: () => void) =>
    h('button', { type: 'button', 'aria-label': label, title: `${label} (${keys})`, onclick }, icon(name));
  const changing = (change: (maze: MazeData) => MazeData) => () => editor.change(change(editor.maze()));
  const undo = sign('undo', 'Undo', 'Ctrl+Z', editor.undo);
  const redo = sign('redo', 'Redo', 'Ctrl+Shift+Z', editor.redo);
  return {
    element: h(
      'div.draw-tools',
      { role: 'toolbar', 'aria-label': 'Drawing' },
      h('fieldset.segments', h('legend.unseen', 'Tool'), ...radios),
      h('span.draw-changes', undo, redo),
      looks,
    ),
    /** Changes of the whole. */
    changes: h(
      'div.row',
      { role: 'group', 'aria-label': 'Change all of it' },
      button('Turn start', 'Turn the start heading a quarter clockwise (R)', changing(withTurnedStart)),
      button('Mirror', 'Swap east and west', changing(mirrored)),
      button('Rotate', 'Turn the whole maze a quarter clockwise', changing(rotated)),
    ),
    /** Undo and redo as the history now allows. */
    show() {
      undo.disabled = !editor.canUndo();
      redo.disabled = !editor.canRedo();
    },
  };
}
