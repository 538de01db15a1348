// A race of a program of the page against built-in mice, and against what it was before.
import type { Core } from '../core/client';
import type { MazeData, PackedRecord, PlayedMouse, RaceResults } from '../core/types';
import { isSameMaze } from '../maze/same';
import { holdRace, type Order, type Progress } from '../results/holding';
import { joined } from '../results/joining';
import { holdContest, type Entry, type ContestOutput } from './contest';
import type { Cage } from './sandbox/cage';

export type Runner = Omit<Entry, 'maze' | 'seed' | 'races'>;

/** A program as it raced: what it did where. */
export interface Version {
  runner: Runner;
  contests: ContestOutput[];
}

export interface Raced {
  results: RaceResults;
  mazes: MazeData[];
  /** Of the program's contests, and of those of the one before. */
  records: PackedRecord[];
  now: Version;
  /** Null where there was none. */
  before: Version | null;
}

/** What a leaderboard calls the program before: by its own name, where that is another. */
export const nameBefore = (before: string, now: string): string =>
  before === now ? `${now.slice(0, 33)}-before` : before;

/** That contest under another name. */
function renamed(held: ContestOutput, name: string): ContestOutput {
  if (held.packed.mouse === name) return held;
  // As the header has it, ahead of all else that could say so.
  const named = (mouse: string) => `"mouse":{"name":${JSON.stringify(mouse)}`;
  const record = held.record.replace(named(held.packed.mouse), () => named(name));
  return { ...held, record, packed: { ...held.packed, mouse: name }, play: { ...held.play, mouse: name } };
}

const played = ({ runner, contests }: Version): PlayedMouse => ({
  name: runner.name,
  spec: runner.language.commandLine,
  contests: contests.map(({ record, started, microseconds }) => ({ record, started, microseconds })),
});

/**
 * The program in all mazes, then the mice. `last` is the version before, whose contests are taken as they were, as far as
 * they were in these mazes. Null where it was stopped; a program that does not even greet races nowhere.
 */
export async function raceProgram(
  core: Core,
  cage: Cage,
  runner: Runner,
  order: Omit<Order, 'mazes'> & { mazes: MazeData[] },
  report: (progress: Progress) => void,
  wanted: () => boolean,
  last: Version | null = null,
): Promise<Raced | { failed: ContestOutput } | null> {
  const { mazes, seed, runs } = order;
  const raced = [runner, ...(last ? [{ ...last.runner, name: nameBefore(last.runner.name, runner.name) }] : [])];
  const all = order.mice.length + raced.length * mazes.length;
  const versions: Version[] = [];
  let done = 0;
  for (const one of raced) {
    const known = one === runner ? [] : last!.contests;
    const contests: ContestOutput[] = [];
    for (const maze of mazes) {
      report({ done: done++, all, doing: `${one.name} in ${maze.name}` });
      const same = known.find(({ play }) => play.maze.name === maze.name && isSameMaze(play, { maze }));
      const entry = { ...one, maze, seed, races: true };
      const held = same ? renamed(same, one.name) : await holdContest(core, cage, entry, wanted);
      if (!held || !wanted()) return null;
      contests.push(held);
      if (!held.started && one === runner) return { failed: held };
    }
    versions.push({ runner: one, contests });
  }
  const own = (await core.call('race', { mice: [], mazes, seed, runs, played: versions.map(played) })).results;
  const others =
    order.mice.length > 0
      ? await holdRace(core, order, (now) => report({ ...now, done: done + now.done, all }), wanted)
      : null;
  if (!wanted()) return null;
  const results = joined([own, ...(others ? [others.results] : [])], others?.results.stopped ?? false);
  const records = versions.flatMap(({ contests }) => contests.map(({ packed }) => packed));
  return results && { results, mazes, records, now: versions[0], before: versions[1] ?? null };
}
