// The maze in which mice run: built in, generated, drawn, or from a file.
import type { MazeData } from '../core/types';
import { Button, Select } from '../ui/controls';
import { Field } from '../ui/field';
import { firstGeneration, Generator, orderOf } from '../ui/generator';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';
import { errorText } from '../ui/format';

type Source = 'built-in' | 'generator' | 'drawing' | 'given';

export type MazeChoice = ReturnType<typeof createMazeChoice>;

/** The built-in maze to begin with. */
const usual = 'capstone-1';

const sources: [Source, string][] = [
  ['built-in', 'Built in'],
  ['generator', 'Generator'],
  ['drawing', 'The drawing'],
  ['given', 'File or link'],
];

/** `chosen` hears of each maze; `draw` of all else that has changed. */
export function createMazeChoice(page: Page, chosen: (maze: MazeData) => void, draw: () => void) {
  const { core, about } = page;
  const state = {
    source: 'built-in' as Source,
    builtin: about.mazes.some(({ name }) => name === usual) ? usual : (about.mazes[0]?.name ?? ''),
    generation: firstGeneration('depth-first'),
    given: null as MazeData | null,
    /** The last one. */
    now: null as MazeData | null,
    error: '',
  };
  async function fetchMaze(from: Source): Promise<MazeData> {
    if (from === 'built-in') return (await core.call('builtin_maze', { name: state.builtin })).maze;
    if (from === 'generator') return (await core.call('make_maze', orderOf(state.generation))).maze;
    const maze = from === 'drawing' ? page.drawn() : state.given;
    if (maze) return maze;
    throw new Error(from === 'drawing' ? 'nothing drawn yet' : 'open a file, or drop one on the page');
  }
  function take(maze: MazeData) {
    Object.assign(state, { now: maze, error: '' });
    chosen(maze);
  }
  const latest = createLatest(
    fetchMaze,
    take,
    (error) => {
      state.error = errorText(error);
      draw();
    },
    150,
  );
  function set(changes: Partial<typeof state> = {}) {
    Object.assign(state, changes);
    draw();
    latest.ask(state.source);
  }
  return {
    page,
    state,
    set,
    /** Chooses that maze, which came from elsewhere. */
    give(maze: MazeData) {
      Object.assign(state, { given: maze, source: 'given' });
      latest.cancel();
      take(maze);
    },
    /** Chooses the built-in maze of that name. */
    choose: (name: string) => set({ source: 'built-in', builtin: name }),
    /** Asks for the chosen maze again; a drawing may have changed. */
    refresh: () => set(),
    isDrawing: () => state.source === 'drawing',
  };
}

/** What belongs to the chosen source. */
function SourcePanel({ choice: { page, state, set } }: { choice: MazeChoice }) {
  const { source, builtin, generation, error } = state;
  const { about } = page;
  if (source === 'generator')
    return <Generator {...{ about, generation, error }} change={(generation) => set({ generation })} />;
  if (source === 'drawing') return <p class="note">The maze in the view Draw.</p>;
  if (source === 'given') return <Button label="Open a file…" act={page.choose} />;
  const named = about.mazes.map(({ name, width, height }) => [name, `${name} · ${width} × ${height}`]);
  return <Select aria-label="Built-in maze" options={named} value={builtin} choose={(builtin) => set({ builtin })} />;
}

export function MazeCard({ choice }: { choice: MazeChoice }) {
  const { page, state, set } = choice;
  const { source, now, error } = state;
  return (
    <section class="card" aria-label="Maze">
      <h2>Maze</h2>
      <Field label="From" error={source === 'generator' ? '' : error}>
        <Select options={sources} value={source} choose={(source) => set({ source: source as Source })} />
      </Field>
      <SourcePanel choice={choice} />
      {now && source !== 'built-in' && (
        <p class="note">
          {now.name || 'a maze'}, {now.width} × {now.height} cells
        </p>
      )}
      <Button label="Edit in Draw" act={() => now && page.draw(now)} />
    </section>
  );
}
