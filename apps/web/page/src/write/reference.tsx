// What a program reads and answers, beside the editor: the same as docs/reference/protocols.md and docs/reference/protocols.md have it.
import type { LanguageId } from './runtime';

type Line = [code: string, meaning: string];

const javascript: Line[] = [
  ['size W H', 'columns and rows of the maze'],
  [
    'start X Y HEADING',
    'where it begins: column and row from the south-west corner, which is 0 0; north, east, south or west',
  ],
  ['goal X Y', 'a goal cell, a line for each'],
  ['stride N', 'the longest movement of one step, in cells'],
  ['budget N', 'the most steps of both runs together'],
  ['seed N', 'for stochastic mice'],
  ['begin', 'answer with the line: labmouse 1'],
  [
    'sense L A R',
    'a step: the open cells to the left, ahead and to the right, up to the next wall. Answer with one line:',
  ],
  ['→ move DEGREES CELLS', 'turn by -90, 0 or 90, clockwise, then go up to 3 cells; negative is backwards'],
  ['→ reset', 'in a goal or after it: back to the start, for the speed run'],
  ['→ forfeit', 'it gives up'],
  ['console.log(…)', 'writes a line to the host'],
  ['console.error(…)', 'prints for you, beside the replay'],
];

const python: Line[] = [
  ['class Robot', 'the robot of the capstone project'],
  [
    '__init__(self, maze_dim)',
    'begins in the cell (0, 0), the south-west corner, and looks north; maze_dim is the side of the maze',
  ],
  ['next_move(self, sensors)', 'one step; sensors are the open cells to the left, ahead and to the right'],
  ['return rotation, movement', 'turn by -90, 0 or 90, clockwise, then go up to 3 cells; negative is backwards'],
  ["return 'Reset', 'Reset'", 'once it was in the centre: back to the start, for the speed run'],
  ['print(…)', 'prints for you, beside the replay'],
];

export const Reference = ({ id }: { id: LanguageId }) => (
  <dl class="reference">
    {(id === 'python' ? python : javascript).map(([code, meaning]) => (
      <>
        <dt>
          <code>{code}</code>
        </dt>
        <dd>{meaning}</dd>
      </>
    ))}
  </dl>
);
