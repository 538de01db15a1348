// Whom a program races against, and where.
import { createMazePicks, createPicks, PickList, usual } from '../choice/picks';
import type { Page } from '../page/page';

export type RaceForm = ReturnType<typeof createRaceForm>;

export function createRaceForm(page: Page) {
  const runners = page.about.mice.filter(({ walks }) => walks !== false);
  const choices = runners.map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) }));
  return { mice: createPicks('Against', choices), mazes: createMazePicks('In mazes', page.about, page.mazes, true) };
}

export const RaceFields = ({ form: { mice, mazes } }: { form: RaceForm }) => (
  <div class="race pictures race-form">
    <PickList picks={mice} />
    <PickList picks={mazes} />
  </div>
);
