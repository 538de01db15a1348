// The maze in which a program runs: the user's own, that of a link, or a built-in one.
import { namedApart } from '../choice/picks';
import type { MazeData } from '../core/types';
import type { Moment } from '../link/address';
import { isSameMaze } from '../maze/same';
import type { Page } from '../page/page';
import { h } from '../ui/dom';

const usualMaze = 'capstone-1';
const nameOf = (one: string | MazeData) => (typeof one === 'string' ? one : one.name);

export function createMazeSelect(page: Page) {
  const element = h('select');
  /** The maze of a link, which is none of the page's. */
  let foreign: MazeData | null = null;
  let mazes: (string | MazeData)[] = [];
  /** Offers the mazes that there are by now. */
  function refresh(chosen = element.value || usualMaze) {
    const { mazes: builtin } = page.about;
    const own = namedApart([...page.mazes(), ...(foreign ? [foreign] : [])], builtin);
    mazes = [...own, ...builtin.map(({ name }) => name)];
    element.replaceChildren(
      ...own.map(({ name }) => h('option', { value: name }, `${name} · yours`)),
      ...builtin.map(({ name, width, height }) => h('option', { value: name }, `${name} · ${width} × ${height}`)),
    );
    if (mazes.some((one) => nameOf(one) === chosen)) element.value = chosen;
  }
  return {
    element,
    refresh,
    /** A built-in one by its name. */
    chosen: () => mazes[element.selectedIndex],
    /** Chooses the maze of a link; nothing where that has none. */
    choose({ builtin }: Moment, maze: MazeData | null) {
      if (!maze) return;
      foreign = builtin.length > 0 ? null : maze;
      refresh();
      const isIt = (one: string | MazeData) =>
        typeof one === 'string' ? one === builtin[0] : foreign && isSameMaze({ maze: one }, { maze: foreign });
      mazes.forEach((one, i) => isIt(one) && (element.selectedIndex = i));
    },
  };
}
