// The contests of a race as rows (mice) and columns (mazes), the same for all worlds.
import type { ContestResult, Fields, RaceGroup, RaceResults } from '../core/types';
import { shortNames } from './names';
import { orNull } from '../ui/format';
import { worldOf, type RacedWorld } from './worlds';

export interface Contest {
  outcome: string;
  finished: boolean;
  score: number | null;
  /** Its score over the best possible one; null where it failed. */
  ratio: number | null;
  seed: number | null;
  search: number | null;
  speed: number | null;
}

export interface Cell {
  contests: Contest[];
  finished: number;
  /** The mean over the finished contests; null where none was. */
  ratio: number | null;
}

export interface BoardMouse {
  name: string;
  /** The same, cut in its middle where it is a whole command. */
  shown: string;
  /** The same for a narrow column. */
  short: string;
  reference: boolean;
  /** Position in its results. */
  index: number;
}

export interface BoardMaze {
  name: string;
  short: string;
  width: number;
  height: number;
  /** The best possible score; null where no goal can be reached. */
  bound: number | null;
  optimum: number | null;
  index: number;
}

export interface Board {
  world: string;
  /** What is shown of that world. */
  shows: RacedWorld;
  /** What its results depend on, such as the budget. */
  conditions: Fields;
  mice: BoardMouse[];
  mazes: BoardMaze[];
  /** By the positions of mouse and maze. */
  cells: Cell[][];
}

const mostShown = 40;
const mostShort = 20;

/** Cut in its middle, because commands differ at their ends. */
function cut(name: string, most: number): string {
  const end = Math.floor(most * 0.4);
  return name.length > most ? `${name.slice(0, most - end - 1)}…${name.slice(-end)}` : name;
}

const mouseOf = (name: string, index: number, reference = false): BoardMouse => ({
  name,
  shown: cut(name, mostShown),
  short: cut(name, mostShort),
  index,
  reference,
});

export const meanOf = (values: number[]) =>
  values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;

function cellOf(contests: Contest[]): Cell {
  const ratios = contests.flatMap(({ ratio }) => (ratio === null ? [] : [ratio]));
  return { contests, finished: contests.filter(({ finished }) => finished).length, ratio: meanOf(ratios) };
}

/** The contests of one mouse, sorted into the mazes. */
function row(results: ContestResult[], mazes: BoardMaze[], world: RacedWorld) {
  const index = new Map(mazes.map((maze) => [maze.name, maze]));
  const contests: Contest[][] = mazes.map(() => []);
  for (const result of results) {
    const maze = index.get(result.maze);
    if (maze) contests[maze.index].push(contestOf(world, result, maze));
  }
  return contests.map(cellOf);
}

function mazesOf({ mazes }: RaceGroup, { bound }: RacedWorld): BoardMaze[] {
  const short = shortNames(mazes.map(({ name }) => name));
  return mazes.map((maze, index) => ({
    name: maze.name,
    short: short[index],
    width: maze.width,
    height: maze.height,
    index,
    bound: bound(maze),
    optimum: orNull(maze.optimum),
  }));
}

/** Some worlds say of a contest whether it was finished, and how its program ended. */
function contestOf(world: RacedWorld, result: ContestResult, maze: BoardMaze): Contest {
  const score = world.score(result);
  const finished = 'finished' in result ? result.finished === true : score !== null;
  return {
    outcome: String(result.end || result.outcome),
    finished,
    score,
    ratio: finished && score !== null && maze.bound ? score / maze.bound : null,
    seed: orNull(result.seed),
    search: orNull(result.search_steps),
    speed: orNull(result.speed_steps),
  };
}

/** One race `among` those of the same results. */
export function boardOf(group: RaceGroup, among: RaceGroup[] = []): Board {
  const world = worldOf(group, among);
  const mazes = mazesOf(group, world);
  return {
    world: group.world,
    shows: world,
    conditions: group,
    mice: group.mice.map((mouse, index) => mouseOf(mouse.name, index, mouse.contestant === false)),
    mazes,
    cells: group.mice.map((mouse) => row(mouse.results, mazes, world)),
  };
}

/** All races of these results that have mice, each world's by itself. */
export const groupsOf = ({ groups }: RaceResults): RaceGroup[] => groups.filter(({ mice }) => mice.length > 0);

export const boardsOf = (results: RaceResults): Board[] =>
  groupsOf(results).map((group, _, all) => boardOf(group, all));
