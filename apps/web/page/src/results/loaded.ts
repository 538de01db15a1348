// A race with what belongs to it: its mazes, from wherever they can be had, and its records.
import type { Core } from '../core/client';
import type { About, MazeData, PackedRecord, RaceResults } from '../core/types';
import type { Order } from './holding';
import { find, stem } from './names';

/** A report that the page carries, or results that were dropped on it. */
export interface LoadedRace {
  results: RaceResults;
  /** The maze of that name, where the race brought it or the core has it. */
  maze(name: string): Promise<MazeData | null>;
  /** The records of those contests; empty where there is none. */
  records(mouse: string, maze: string): Promise<PackedRecord[]>;
  /** What was asked for, where the race was held in the page. */
  order?: Order;
}

export interface Sources {
  core: Core;
  ready: Promise<About>;
  /** Mazes that came with the report, by name, as links. */
  links: Map<string, string>;
  /** The mazes that raced, where the race was held in the page. */
  raced?: MazeData[];
  /** What was asked for, where the race was held in the page. */
  order?: Order;
  /** Mazes that were opened in the page, by name. */
  opened: Map<string, MazeData>;
  /** Reads the records; called once, when the first is asked for. */
  records: () => Promise<PackedRecord[]>;
}

/** The maze of that name that the core brings; null where it has none. */
async function builtin({ core, ready }: Sources, name: string): Promise<MazeData | null> {
  const about = await ready;
  const known = about.mazes.find((maze) => maze.name === name) ?? about.mazes.find((maze) => maze.name === stem(name));
  return known ? (await core.call('builtin_maze', { name: known.name })).maze : null;
}

async function findMaze(sources: Sources, name: string): Promise<MazeData | null> {
  const raced = sources.raced?.find((maze) => maze.name === name);
  if (raced) return raced;
  const link = find(sources.links, name);
  if (link !== undefined) return (await sources.core.call('read_link', { link })).maze;
  return find(sources.opened, name) ?? (await builtin(sources, name));
}

const fits = (maze: MazeData, raced: { width: number; height: number } | undefined) =>
  !raced || (raced.width === maze.width && raced.height === maze.height);

const keyOf = (mouse: string, maze: string) => `${mouse}\n${stem(maze)}`;

function byContest(records: PackedRecord[]): Map<string, PackedRecord[]> {
  const index = new Map<string, PackedRecord[]>();
  for (const record of records) {
    const key = keyOf(record.mouse, record.maze);
    index.set(key, [...(index.get(key) ?? []), record]);
  }
  return index;
}

/** Those results with their mazes and records. */
export function loadedRace(results: RaceResults, sources: Sources): LoadedRace {
  let index: Promise<Map<string, PackedRecord[]>> | null = null;
  const raced = new Map(results.groups.flatMap(({ mazes }) => mazes).map((maze) => [maze.name, maze]));
  return {
    results,
    order: sources.order,
    async maze(name) {
      const maze = await findMaze(sources, name);
      return maze && fits(maze, raced.get(name)) ? maze : null;
    },
    async records(mouse, maze) {
      index ??= sources.records().then(byContest);
      const alike = (await index).get(keyOf(mouse, maze)) ?? [];
      const same = alike.filter((record) => record.maze === maze);
      return same.length > 0 ? same : alike;
    },
  };
}
