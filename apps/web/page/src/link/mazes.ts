// Mazes in links: built-in ones by name, others as the core writes them.
import type { Core } from '../core/client';
import type { About, MazeData } from '../core/types';
import { isSameMaze } from '../maze/same';
import type { Moment } from './address';

type Places = Pick<Moment, 'builtin' | 'mazes'>;

/** Whether the core brings that very maze under its name. */
async function isBuiltin(core: Core, about: About, maze: MazeData): Promise<boolean> {
  if (!about.mazes.some(({ name }) => name === maze.name)) return false;
  return isSameMaze({ maze }, await core.call('builtin_maze', { name: maze.name }));
}

/** How a link names that maze. */
export async function placeOf(core: Core, about: About, maze: MazeData): Promise<Places> {
  if (await isBuiltin(core, about, maze)) return { builtin: [maze.name], mazes: [] };
  return { builtin: [], mazes: [(await core.call('link', { maze })).link] };
}

/** The same for many: `all` where all of the core are among them. */
export async function placesOf(core: Core, about: About, mazes: (string | MazeData)[]): Promise<Places> {
  const named = mazes.filter((maze) => typeof maze === 'string');
  const others = mazes.filter((maze) => typeof maze !== 'string');
  const links = await Promise.all(others.map(async (maze) => (await core.call('link', { maze })).link));
  return { builtin: named.length === about.mazes.length ? ['all'] : named, mazes: links };
}

/** The one maze that a link names; null where it names none. */
export async function mazeAt(core: Core, { builtin, mazes }: Places): Promise<MazeData | null> {
  if (builtin.length + mazes.length > 1) throw new Error('This link cannot be followed: it names more than one maze.');
  if (builtin.length > 0) return (await core.call('builtin_maze', { name: builtin[0] })).maze;
  if (mazes.length > 0) return (await core.call('read_link', { link: mazes[0] })).maze;
  return null;
}
