// A race in the page, mouse by mouse, so that the page stays lively between the pieces.
import { Stopped, type Core } from '../core/client';
import type { MazeData, RaceResults, WorldInPage } from '../core/types';
import { joined, sideBySide } from './joining';

/** Settings of a world by their names, as the core's `race` takes them. */
export type Settings = Record<string, string | number | boolean>;

export interface Order {
  mice: string[];
  /** Those that the core brings by their names. */
  mazes: (string | MazeData)[];
  /** Contests of each stochastic mouse, in each maze. */
  runs: number;
  seed: number;
  /** The world, with what is set of it; the first one where it is missing. */
  world?: Settings & { world: string };
}

export interface Progress {
  done: number;
  all: number;
  doing: string;
}

export const mazesOf = (core: Core, mazes: Order['mazes']): Promise<MazeData[]> =>
  Promise.all(
    mazes.map(async (maze) =>
      typeof maze === 'string' ? (await core.call('builtin_maze', { name: maze })).maze : maze,
    ),
  );

/** The settings of each race of an order: one for each value of a setting that may have several, such as `noise`. */
export function eachOf(world: Order['world'], worlds: WorldInPage[]): Order['world'][] {
  const settings = worlds.find(({ name }) => name === world?.world)?.settings ?? [];
  let all: Order['world'][] = [world];
  for (const { name, listed } of settings) {
    const value = world?.[name];
    if (!listed || typeof value !== 'string') continue;
    const values = value.split(',').map((one) => one.trim());
    all = all.flatMap((one) => values.map((chosen) => ({ ...one!, [name]: chosen })));
  }
  return all;
}

/** Runs the race; `wanted` is asked between mice whether to go on. Null where it was stopped before its first end. */
export async function holdRace(
  core: Core,
  order: Order,
  report: (progress: Progress) => void,
  wanted: () => boolean,
): Promise<{ results: RaceResults; mazes: MazeData[] } | null> {
  const all = order.mice.length;
  report({ done: 0, all, doing: order.mice[0] });
  const mazes = await mazesOf(core, order.mazes);
  const worlds = order.world ? eachOf(order.world, (await core.call('about', {})).worlds) : [undefined];
  const pieces: RaceResults[] = [];
  for (const [done, mouse] of order.mice.entries()) {
    if (!wanted()) break;
    report({ done, all, doing: mouse });
    const { seed, runs } = order;
    const held: RaceResults[] = [];
    for (const world of worlds) {
      if (!wanted()) break;
      const asked = core.call('race', { mice: [mouse], mazes, seed, runs, ...world });
      // What was stopped in the middle is left out, and what was raced before it stays.
      const piece = await asked.catch((error) => {
        if (error instanceof Stopped) return null;
        throw error;
      });
      if (!piece) break;
      held.push(piece.results);
    }
    if (held.length < worlds.length) break;
    pieces.push(sideBySide(held));
  }
  const results = joined(pieces, pieces.length < all);
  return results && { results, mazes };
}
