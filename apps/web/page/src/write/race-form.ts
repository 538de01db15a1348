// Whom a program races against, and where.
import { mazePicks, picks, usual } from '../choice/picks';
import type { Page } from '../page/page';
import { h } from '../ui/dom';

export function createRaceForm(page: Page) {
  const runners = page.about.mice.filter(({ walks }) => walks !== false);
  const mice = picks(
    'Against',
    runners.map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) })),
  );
  const mazes = mazePicks('In mazes', page.about, page.mazes, true);
  return {
    element: h('div.race.pictures.race-form', mice.element, mazes.element),
    mice: mice.chosen,
    mazes: mazes.chosenMazes,
    refresh: mazes.refresh,
  };
}
