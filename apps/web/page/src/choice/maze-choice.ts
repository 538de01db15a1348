// The maze in which mice run: built in, generated, drawn, or from a file.
import type { MazeData } from '../core/types';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import { createGenerator } from '../ui/generator';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';
import { errorText } from '../ui/format';

type Source = 'built-in' | 'generator' | 'drawing' | 'given';

export type MazeChoice = ReturnType<typeof createMazeChoice>;

/** The built-in maze to begin with. */
const usual = 'capstone-1';

const sources: { source: Source; label: string }[] = [
  { source: 'built-in', label: 'Built in' },
  { source: 'generator', label: 'Generator' },
  { source: 'drawing', label: 'The drawing' },
  { source: 'given', label: 'File or link' },
];

/** The control of each source; the generator also says what is wrong with its order. */
function createPanels(page: Page) {
  const named = page.about.mazes.map(({ name, width, height }) =>
    h('option', { value: name, selected: name === usual }, `${name} · ${width} × ${height}`),
  );
  const builtin = h('select', { 'aria-label': 'Built-in maze' }, ...named);
  const generator = createGenerator(page.about, { first: 'depth-first' });
  const elements: Record<Source, HTMLElement> = {
    'built-in': builtin,
    generator: generator.element,
    drawing: h('p.note', 'The maze in the view Draw.'),
    given: button('Open a file…', page.choose),
  };
  return { builtin, generator, elements };
}

/** `chosen` hears of each maze. */
export function createMazeChoice(page: Page, chosen: (maze: MazeData) => void) {
  let given: MazeData | null = null;
  let now: MazeData | null = null;
  const source = h('select', ...sources.map((one) => h('option', { value: one.source }, one.label)));
  const row = field('From', source);
  const note = h('p.note');
  const { builtin, generator, elements } = createPanels(page);
  const showPanel = () => sources.forEach((one) => (elements[one.source].hidden = one.source !== source.value));

  async function fetchMaze(from: Source): Promise<MazeData> {
    if (from === 'built-in') return (await page.core.call('builtin_maze', { name: builtin.value })).maze;
    if (from === 'generator') return (await page.core.call('make_maze', generator.order())).maze;
    const maze = from === 'drawing' ? page.drawn() : given;
    if (maze) return maze;
    throw new Error(from === 'drawing' ? 'nothing drawn yet' : 'open a file, or drop one on the page');
  }
  function complain(message: string) {
    const isGenerator = source.value === 'generator';
    generator.complain(isGenerator ? message : '');
    row.complain(isGenerator ? '' : message);
  }
  function take(maze: MazeData) {
    complain('');
    now = maze;
    note.hidden = source.value === 'built-in';
    note.replaceChildren(`${maze.name || 'a maze'}, ${maze.width} × ${maze.height} cells`);
    chosen(maze);
  }
  const latest = createLatest(fetchMaze, take, (error) => complain(errorText(error)), 150);
  function ask() {
    showPanel();
    latest.ask(source.value as Source);
  }
  function give(maze: MazeData) {
    given = maze;
    source.value = 'given';
    showPanel();
    latest.cancel();
    take(maze);
  }
  const edit = button('Edit in Draw', () => now && page.draw(now));
  const content = [h('h2', 'Maze'), row, ...sources.map((one) => elements[one.source]), note, edit];
  source.addEventListener('change', ask);
  builtin.addEventListener('change', ask);
  generator.element.addEventListener('input', ask);
  return {
    element: h('section.card', { 'aria-label': 'Maze' }, ...content),
    /** Chooses that maze, which came from elsewhere. */
    give,
    /** Chooses the built-in maze of that name. */
    choose(name: string) {
      source.value = 'built-in';
      builtin.value = name;
      ask();
    },
    /** Asks for the chosen maze again; a drawing may have changed. */
    refresh: ask,
    isDrawing: () => source.value === 'drawing',
  };
}
