// The maze in which a program runs: the user's own, that of a link, or a built-in one.
import { namedApart } from '../choice/picks';
import type { MazeData } from '../core/types';
import type { Moment } from '../link/address';
import { isSameMaze } from '../maze/same';
import type { Page } from '../page/page';
import { Select } from '../ui/controls';

const usualMaze = 'capstone-1';
const nameOf = (one: string | MazeData) => (typeof one === 'string' ? one : one.name);

export type MazeSelect = ReturnType<typeof createMazeSelect>;

export function createMazeSelect(page: Page) {
  const { mazes: builtin } = page.about;
  let name = usualMaze;
  /** The maze of a link, which is none of the page's. */
  let foreign: MazeData | null = null;
  /** Those that there are by now. */
  const own = () => namedApart([...page.mazes(), ...(foreign ? [foreign] : [])], builtin);
  const all = () => [...own(), ...builtin.map(({ name }) => name)];
  /** A built-in one by its name. */
  const chosen = () => all().find((one) => nameOf(one) === name) ?? all()[0];
  return {
    chosen,
    options: () => [
      ...own().map(({ name }) => [name, `${name} · yours`]),
      ...builtin.map(({ name, width, height }) => [name, `${name} · ${width} × ${height}`]),
    ],
    pick: (next: string) => void (name = next),
    /** Chooses the maze of a link; nothing where that has none. */
    choose({ builtin }: Moment, maze: MazeData | null) {
      if (!maze) return;
      foreign = builtin.length > 0 ? null : maze;
      const isIt = (one: string | MazeData) =>
        typeof one === 'string' ? one === builtin[0] : foreign && isSameMaze({ maze: one }, { maze: foreign });
      const found = all().filter(isIt).at(-1);
      if (found) name = nameOf(found);
    },
  };
}

export const MazeField = ({ mazes, draw }: { mazes: MazeSelect; draw: () => void }) => (
  <label>
    <span class="unseen">Maze</span>
    <Select options={mazes.options()} value={nameOf(mazes.chosen())} choose={(name) => (mazes.pick(name), draw())} />
  </label>
);
