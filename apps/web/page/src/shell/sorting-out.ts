// What dropped files turned out to be. Only the core can tell.
import type { MazeData, Opened, Play, RaceResults } from '../core/types';
import { notesOn } from '../ui/format';

export interface OneFile {
  name: string;
  bytes: Uint8Array;
}

export interface SortedOut {
  mazes: MazeData[];
  /** On how mazes were read. */
  notes: string[];
  plays: { play: Play; record: string }[];
  results: RaceResults[];
  robots: { name: string; text: string }[];
  refused: { file: OneFile; error: unknown }[];
}

export type Open = (file: OneFile, maze?: MazeData) => Promise<Opened>;

function add(sorted: SortedOut, file: OneFile, opened: Opened) {
  if (opened.kind === 'maze') {
    sorted.mazes.push(opened.maze);
    sorted.notes.push(...notesOn(file.name, opened.notes));
  } else if (opened.kind === 'results') sorted.results.push(opened.results);
  else if (opened.kind === 'robot') sorted.robots.push({ name: opened.name, text: opened.text });
  else sorted.plays.push({ play: opened.play, record: new TextDecoder().decode(file.bytes) });
}

/** Opens `file` as a record in the first of those mazes that it fits; null where it fits none. */
export async function openIn(
  file: OneFile,
  mazes: MazeData[],
  open: Open,
): Promise<{ maze: MazeData; opened: Opened } | null> {
  for (const maze of mazes) {
    const opened = await open(file, maze).catch(() => null);
    if (opened?.kind === 'record') return { maze, opened };
  }
  return null;
}

/** Opens all; a record that lacks its maze takes one that was dropped with it. */
export async function sortOut(files: OneFile[], open: Open): Promise<SortedOut> {
  const sorted: SortedOut = { mazes: [], notes: [], plays: [], results: [], robots: [], refused: [] };
  const failed: SortedOut['refused'] = [];
  for (const file of files)
    await open(file).then(
      (opened) => add(sorted, file, opened),
      (error) => failed.push({ file, error }),
    );
  for (const failure of failed) {
    const found = await openIn(failure.file, sorted.mazes, open);
    if (found) add(sorted, failure.file, found.opened);
    else sorted.refused.push(failure);
  }
  return sorted;
}
