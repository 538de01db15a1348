// The contests of a race as rows (mice) and columns (mazes), the same for both worlds.
import type { ContestResult, MmsGroup, RacedMouse, RaceResults } from '../core/types';
import { shortNames } from '../report/names';
import { isNumber } from './format';

export interface Contest {
  outcome: string;
  solved: boolean;
  score: number | null;
  /** Its score over the best possible one; null where it failed. */
  ratio: number | null;
  seed: number | null;
  exploration: number | null;
  speed: number | null;
  /** What the mouse wrote last. */
  words: string;
}

export interface Cell {
  contests: Contest[];
  solved: number;
  /** The mean over the solved contests; null where none was. */
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
  world: 'steps' | 'mms';
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

const orNull = (value: unknown) => (isNumber(value) ? value : null);

export const meanOf = (values: number[]) =>
  values.length === 0 ? null : values.reduce((sum, value) => sum + value, 0) / values.length;

function cellOf(contests: Contest[]): Cell {
  const ratios = contests.flatMap(({ ratio }) => (ratio === null ? [] : [ratio]));
  return { contests, solved: contests.filter(({ solved }) => solved).length, ratio: meanOf(ratios) };
}

/** The contests of one mouse, sorted into the mazes. */
function row<Result extends { maze: string }>(
  results: Result[],
  mazes: BoardMaze[],
  read: (result: Result, maze: BoardMaze) => Contest,
) {
  const index = new Map(mazes.map((maze) => [maze.name, maze]));
  const contests: Contest[][] = mazes.map(() => []);
  for (const result of results) {
    const maze = index.get(result.maze);
    if (maze) contests[maze.index].push(read(result, maze));
  }
  return contests.map(cellOf);
}

function mazesOf(
  mazes: { name: string; width: number; height: number }[],
  best: (index: number) => Pick<BoardMaze, 'bound' | 'optimum'>,
) {
  const short = shortNames(mazes.map(({ name }) => name));
  return mazes.map(({ name, width, height }, index) => ({
    name,
    short: short[index],
    width,
    height,
    index,
    ...best(index),
  }));
}

function ourContest(result: ContestResult, maze: BoardMaze): Contest {
  const score = orNull(result.score);
  return {
    outcome: result.outcome,
    solved: score !== null,
    score,
    ratio: score !== null && maze.bound ? score / maze.bound : null,
    seed: orNull(result.seed),
    exploration: orNull(result.exploration_steps),
    speed: orNull(result.speed_steps),
    words: String(result.last_words ?? ''),
  };
}

/** Our own rules. */
export function stepsBoard(results: RaceResults): Board {
  const mazes = mazesOf(results.mazes, (index) => ({
    bound: orNull(results.mazes[index].bound),
    optimum: orNull(results.mazes[index].optimum),
  }));
  return {
    world: 'steps',
    mice: results.mice.map((mouse: RacedMouse, index) => mouseOf(mouse.name, index, mouse.contestant === false)),
    mazes,
    cells: results.mice.map((mouse) => row(mouse.results, mazes, ourContest)),
  };
}

function mmsContest(result: MmsGroup['mice'][number]['results'][number]): Contest {
  return {
    outcome: result.end || result.outcome,
    solved: result.solved === true,
    score: orNull(result.score),
    ratio: orNull(result.ratio),
    seed: null,
    exploration: null,
    speed: null,
    words: Array.isArray(result.errors) ? result.errors.join('\n') : '',
  };
}

/** The world of mms. */
export function mmsBoard(group: MmsGroup): Board {
  const mazes = mazesOf(group.mazes, (index) => ({
    bound: orNull(group.mazes[index].best_score),
    optimum: orNull(group.mazes[index].best_run),
  }));
  return {
    world: 'mms',
    mice: group.mice.map(({ name }, index) => mouseOf(name, index)),
    mazes,
    cells: group.mice.map((mouse) => row(mouse.results, mazes, mmsContest)),
  };
}

/** One board for each world in which mice raced. */
export const boardsOf = (results: RaceResults): Board[] =>
  [stepsBoard(results), ...(results.groups ?? []).map(mmsBoard)].filter(({ mice }) => mice.length > 0);
