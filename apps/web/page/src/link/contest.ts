// Contests in links: a mouse, its seed and the conditions under which it runs, as the core runs them.
import { isMine } from './my-robot';
import type { Core } from '../core/client';
import type { About, MazeData, Play } from '../core/types';
import type { Moment } from './address';

export interface Contest {
  mouse: string;
  maze: MazeData;
  seed: number;
  budget?: number;
  /** In the world of drivingWorld(). */
  drive?: Driven;
}

/** What is driven where. */
export type Driven = { world: string; robot: string; rules: string };

/** The world of which links name robot and rules alone: that of driving robots without chance. */
export const drivingWorld = ({ worlds }: About) =>
  worlds.find(({ is_stochastic, settings }) => !is_stochastic && settings.some(({ name }) => name === 'robot'));

/** Runs it. */
export const contestOf = (core: Core, { mouse, maze, seed, budget, drive }: Contest) =>
  core.call('contest', { mouse, maze, seed, ...(drive ?? (budget !== undefined && { budget })) });

/** What was asked for, so that a play came of it; null where the page runs no such contest. */
function asked(play: Play, about: About): Contest | null {
  const { mouse, maze, seed, rules, drive, again, world } = play;
  if (seed === null || !again || (drive && world !== drivingWorld(about)?.name)) return null;
  if (drive) return { mouse, maze, seed, drive: { world, robot: drive.robot.name, rules: drive.rules.name } };
  return { mouse, maze, seed, ...(rules && { budget: rules.budget }) };
}

const walk = ({ action, clock, outcome, score }: Play) => JSON.stringify([action, clock, outcome, score]);

/** The contest of a play, after the core has run it again and has done the same; throws in words where it has not. */
export async function contestBehind(core: Core, play: Play, about: About): Promise<Contest> {
  const contest = asked(play, about);
  const again = contest && (await contestOf(core, contest).catch(() => null));
  if (contest && again && walk(again.play) === walk(play)) return contest;
  throw new Error(
    `A link cannot hold this contest of ${play.mouse}, for this page would not run it so again. Save its record and send that.`,
  );
}

/** What a link says of contests that differ in mouse and seed alone. */
export function contestsInMoment(contests: Contest[], about: About): Pick<Moment, 'mice' | 'seeds'> & Partial<Moment> {
  const [{ budget, drive }] = contests;
  const seeds = contests.map(({ seed }) => seed);
  return {
    mice: contests.map(({ mouse }) => mouse),
    seeds: new Set(seeds).size === 1 ? seeds.slice(0, 1) : seeds,
    ...(budget !== undefined && budget !== about.rules.budget && { budget }),
    ...(drive && { robot: drive.robot, rules: drive.rules }),
  };
}

/** The robot and the rules that a link names; null where it names none. Throws in words where the page has them not. */
export function driveOf({ robot, rules }: Pick<Moment, 'robot' | 'rules'>, about: About): Driven | null {
  if (robot === undefined && rules === undefined) return null;
  const known = (names: string[], name: string | undefined, what: string) => {
    if (name === undefined) return names[0] ?? '';
    if (names.includes(name)) return name;
    throw new Error(`This link cannot be followed: this page has no ${what} '${name.slice(0, 40)}'.`);
  };
  const robots = about.robots.map(({ name }) => name);
  // One of the view Robot stands in the link with all of its numbers.
  const ours = robot !== undefined && isMine(robot) ? robot : known(robots, robot, 'robot');
  const world = drivingWorld(about);
  const choices = world?.settings.find(({ name }) => name === 'rules')?.choices ?? [];
  return { world: world?.name ?? '', robot: ours, rules: known(choices, rules, 'rules') };
}

/** The contests that a link names, in that maze. */
export function contestsOf({ mice, seeds, budget, robot, rules }: Moment, about: About, maze: MazeData): Contest[] {
  const drive = driveOf({ robot, rules }, about) ?? undefined;
  return mice.map((mouse, i) => ({ mouse, maze, seed: seeds[i] ?? seeds[0] ?? 1, budget, drive }));
}
