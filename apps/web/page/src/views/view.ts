// What every view is given, and what it gives.
import type { Core } from '../core/client';
import type { About, MazeData, PackedRecord, Play, RaceResults } from '../core/types';

/** A report that the page carries, or results that were dropped on it. */
export interface LoadedRace {
  results: RaceResults;
  /** The maze of that name, where the race brought it or the core has it. */
  maze(name: string): Promise<MazeData | null>;
  /** The records of those contests; empty where there is none. */
  records(mouse: string, maze: string): Promise<PackedRecord[]>;
}

/** The page around the views. */
export interface Page {
  core: Core;
  about: About;
  /** What the page was opened with, or what was dropped on it; null where it has no race yet. */
  race(): LoadedRace | null;
  /** Opens the replay with one play, or two beside each other on one clock. */
  replay(plays: { play: Play; record: string }[]): void;
  /** Opens the maze in Live, or in Draw. */
  live(maze: MazeData): void;
  draw(maze: MazeData): void;
  /** The maze of the drawing, for Live; null while there is none. */
  drawn(): MazeData | null;
  /** Says something to all readers: a status, or what went wrong (with its lines). */
  tell(message: string): void;
  complain(error: unknown): void;
  /** Gives the user a file. */
  save(fileName: string, content: string | Uint8Array<ArrayBuffer>, type?: string): void;
}

/** One of the four views; built once, shown and hidden. */
export interface View {
  element: HTMLElement;
  /** Called when the view is shown, and when what it shows has changed. */
  shown(): void;
  /** Called when another one is shown. */
  hidden?(): void;
  /** A dropped or linked thing that is for this view. */
  accept?(thing: unknown): void;
}
