// Whom a program races against, and where.
import type { MazeData } from '../core/types';
import { namedApart, picks, usual } from '../choice/picks';
import type { Page } from '../page/page';
import { h } from '../ui/dom';

export interface RaceForm {
  element: HTMLElement;
  mice(): string[];
  /** Built-in ones by their names. */
  mazes(): (string | MazeData)[];
  /** Offers the mazes that there are by now. */
  refresh(): void;
}

export function createRaceForm(page: Page): RaceForm {
  const { about } = page;
  const mice = picks(
    'Against',
    about.mice
      .filter(({ walks }) => walks !== false)
      .map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) })),
  );
  const builtin = about.mazes.map(({ name, width, height }) => ({ name, about: `${width}×${height}`, on: true }));
  const mazes = picks('In mazes', builtin);
  let own = new Map<string, MazeData>();
  function refresh() {
    const taken = builtin.map(({ name }) => name);
    own = new Map(namedApart(page.mazes(), taken).map((maze) => [maze.name, maze]));
    const yours = [...own.values()].map(({ name, width, height }) => ({
      name,
      about: `${width}×${height}, yours`,
      on: true,
    }));
    mazes.offer([...yours, ...builtin]);
  }
  refresh();
  return {
    element: h('div', { class: 'race pictures race-form' }, mice.element, mazes.element),
    mice: mice.chosen,
    mazes: () => mazes.chosen().map((name) => own.get(name) ?? name),
    refresh,
  };
}
