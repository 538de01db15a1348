// What happens with files that reach the page: each goes to the core, and then to the view that it belongs to.
import type { MazeData, Play, RaceResults } from '../core/types';
import type { Page } from '../page/page';
import { counted } from '../ui/format';
import type { Notices } from './notices';
import { openIn, sortOut, type OneFile, type Open, type SortedOut } from './sorting-out';

const mostBytes = 200e6;

export interface Takers {
  /** All mazes that came, at least one; the last is to be shown. */
  mazes(mazes: MazeData[]): void;
  plays(plays: { play: Play; record: string }[]): void;
  results(results: RaceResults): void;
  /** A robot file; what is wrong with it is said where it is edited. */
  robot(robot: { name: string; text: string }): void;
  /** A program of a mouse. */
  program(file: File): void;
  /** Mazes at hand, for records that lack theirs, and where they are. */
  atHand(): { place: string; maze: MazeData }[];
}

async function read(file: File): Promise<OneFile> {
  if (file.size > mostBytes)
    throw new Error(
      `${file.name} is too large: ${Math.round(file.size / 1e6)} MB; at most ${mostBytes / 1e6} MB are read`,
    );
  return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
}

/** What was opened, in words, and what of it is to be known at once. */
export function summary({ mazes, notes, plays, results, robots }: SortedOut): string {
  const parts = [mazes.length && counted(mazes.length, 'maze'), plays.length && counted(plays.length, 'record')];
  if (results.length > 0) parts.push('the results of a race');
  if (robots.length > 0) parts.push(counted(robots.length, 'robot'));
  const opened = parts.filter(Boolean).join(', ');
  const cut = plays.filter(({ play }) => !play.ended);
  const rest = [
    ...notes,
    ...cut.map(({ play }) => `${play.mouse}: ${play.outcome}.`),
    plays.length > 2 && 'The first two records are shown.',
    mazes.length > 1 && 'The last maze is shown.',
  ];
  return opened === '' ? '' : [`Opened: ${opened}.`, ...rest.filter(Boolean)].join(' ');
}

/** Takes files as they come. */
export function fileTaker(core: Page['core'], notices: Notices, takers: Takers): (files: File[]) => Promise<void> {
  const open: Open = (file, maze) => core.call('open', { name: file.name, ...(maze && { maze }) }, file.bytes);

  /** Says what is wrong with a file; where it is a record for a maze at hand, offers that. */
  async function refuse({ file, error }: SortedOut['refused'][number]) {
    const places = takers.atHand();
    const found = await openIn(
      file,
      places.map(({ maze }) => maze),
      open,
    );
    if (!found || found.opened.kind !== 'record') return notices.complain(error);
    const { play } = found.opened;
    const { place } = places.find(({ maze }) => maze === found.maze)!;
    const record = new TextDecoder().decode(file.bytes);
    notices.complain(error, {
      label: `Play it in the maze of ${place}${found.maze.name ? `, ${found.maze.name}` : ''}`,
      act: () => takers.plays([{ play, record }]),
    });
  }

  return async (dropped) => {
    notices.clear();
    const programs = dropped.filter(({ name }) => /\.(js|mjs|py)$/i.test(name));
    const files = dropped.filter((file) => !programs.includes(file));
    if (programs.length > 0) takers.program(programs[programs.length - 1]);
    if (files.length === 0) return;
    notices.tell(`Reading ${counted(files.length, 'file')} …`);
    const contents = await Promise.allSettled(files.map(read));
    const sorted = await sortOut(
      contents.flatMap((one) => (one.status === 'fulfilled' ? [one.value] : [])),
      open,
    );
    for (const one of contents) if (one.status === 'rejected') notices.complain(one.reason);
    for (const failure of sorted.refused) await refuse(failure);
    if (sorted.mazes.length > 0) takers.mazes(sorted.mazes);
    if (sorted.results.length > 0) takers.results(sorted.results[sorted.results.length - 1]);
    if (sorted.plays.length > 0) takers.plays(sorted.plays.slice(0, 2));
    if (sorted.robots.length > 0) takers.robot(sorted.robots[sorted.robots.length - 1]);
    notices.tell(summary(sorted));
  };
}
