// What the view of a race begins with: a small race of mice that the page has, held at once.
import { loadedRace, type LoadedRace, type Sources } from './loaded';
import { holdRace, type Order } from './holding';

const mice = ['ariadne', 'flood-return', 'flood'];
const mostMazes = 3;
/** The size of the mazes of contests. */
const side = 16;

/** Null where it is not wanted any more. */
export async function exampleRace(
  { core, ready }: Pick<Sources, 'core' | 'ready'>,
  wanted: () => boolean,
): Promise<LoadedRace | null> {
  const { mazes: all } = await ready;
  const names = all.filter(({ width, height }) => width === side && height === side).map(({ name }) => name);
  const order: Order = { mice, mazes: names.slice(0, mostMazes), runs: 1, seed: 1 };
  const held = await holdRace(core, order, () => undefined, wanted);
  if (!held || !wanted()) return null;
  const sources = { core, ready, links: new Map(), opened: new Map(), records: async () => [] };
  return loadedRace(held.results, { ...sources, raced: held.mazes, order });
}
