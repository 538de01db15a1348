// A race of a program of the page against mice of the roster.
import type { Core } from '../core/client';
import type { MazeData, PackedRecord, PlayedMouse, RaceResults } from '../core/types';
import { holdRace, type Order, type Progress } from '../race/holding';
import { joined } from '../race/joining';
import { holdContest, type Entry, type Held } from './contest';
import type { Cage } from './sandbox/cage';

export interface Raced {
  results: RaceResults;
  mazes: MazeData[];
  /** Of the program's contests. */
  records: PackedRecord[];
  /** The same, whole. */
  contests: Held[];
}

type Runner = Omit<Entry, 'maze' | 'seed' | 'races'>;

/** The program in all mazes, then the mice. Null where it was stopped; a program that does not even greet races nowhere. */
export async function raceProgram(
  core: Core,
  cage: Cage,
  runner: Runner,
  order: Omit<Order, 'mazes'> & { mazes: MazeData[] },
  report: (progress: Progress) => void,
  wanted: () => boolean,
): Promise<Raced | { failed: Held } | null> {
  const all = order.mice.length + order.mazes.length;
  const contests: Held[] = [];
  for (const [done, maze] of order.mazes.entries()) {
    report({ done, all, doing: `${runner.name || runner.language.commandLine} in ${maze.name}` });
    const held = await holdContest(core, cage, { ...runner, maze, seed: order.seed, races: true }, wanted);
    if (!held) return null;
    contests.push(held);
    if (!held.started) return { failed: held };
  }
  const played: PlayedMouse = {
    name: runner.name,
    spec: runner.language.commandLine,
    contests: contests.map(({ record, started, microseconds }) => ({ record, started, microseconds })),
  };
  const { mazes, seed, runs } = order;
  const own = (await core.call('race', { mice: [], mazes, seed, runs, played: [played] })).results;
  const others =
    order.mice.length > 0
      ? await holdRace(core, order, (now) => report({ ...now, done: mazes.length + now.done, all }), wanted)
      : null;
  if (!wanted()) return null;
  const results = joined([own, ...(others ? [others.results] : [])], others?.results.stopped ?? false);
  return results && { results, mazes, records: contests.map(({ packed }) => packed), contests };
}
