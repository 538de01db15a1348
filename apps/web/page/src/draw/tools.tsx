// The tools above the drawing: what the pointer draws, back and forth, and changes of the whole.
import type { ComponentChildren } from 'preact';
import type { MazeData } from '../core/types';
import { Sign } from '../player/sign';
import type { Editor } from './editor';
import { mirrored, rotated, withTurnedStart } from './model';
import type { Tool } from './strokes';
import { Button } from '../ui/controls';

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

interface ToolsProps {
  editor: Editor;
  tool: Tool | 'look';
  choose(tool: Tool | 'look'): void;
  /** How one looks at it. */
  children: ComponentChildren;
}

export const Tools = ({ editor, tool: chosen, choose, children }: ToolsProps) => (
  <div class="draw-tools" role="toolbar" aria-label="Drawing">
    <fieldset class="segments">
      <legend class="unseen">Tool</legend>
      {tools.map(({ tool, label, title }) => (
        <label title={title}>
          <input type="radio" name="draw-tool" value={tool} checked={tool === chosen} onChange={() => choose(tool)} />
          <span>{label}</span>
        </label>
      ))}
    </fieldset>
    <span class="draw-changes">
      <Sign icon="undo" label="Undo" keys="Ctrl+Z" disabled={!editor.canUndo()} act={editor.undo} />
      <Sign icon="redo" label="Redo" keys="Ctrl+Shift+Z" disabled={!editor.canRedo()} act={editor.redo} />
    </span>
    {children}
  </div>
);

const changes: [label: string, title: string, change: (maze: MazeData) => MazeData][] = [
  ['Turn start', 'Turn the start heading a quarter clockwise (R)', withTurnedStart],
  ['Mirror', 'Swap east and west', mirrored],
  ['Rotate', 'Turn the whole maze a quarter clockwise', rotated],
];

/** Changes of the whole. */
export const Changes = ({ editor }: { editor: Editor }) => (
  <div class="row" role="group" aria-label="Change all of it">
    {changes.map(([label, title, change]) => (
      <Button label={label} title={title} act={() => editor.change(change(editor.maze()))} />
    ))}
  </div>
);
