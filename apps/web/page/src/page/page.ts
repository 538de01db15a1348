// What every view is given, and what it gives.
import type { Core } from '../core/client';
import type { LoadedRace } from '../results/loaded';
import type { Shelf } from './shelf';
import type { Camera } from '../maze/camera';
import type { Order } from '../results/holding';
import type { About, MazeData, PackedRecord, Play, RaceResults } from '../core/types';

/** The page around the views, as it is from the first moment on, while the core starts. */
export interface EarlyPage {
  core: Core;
  /** What the core brings; rejected where it cannot start (the page has said so then). */
  ready: Promise<About>;
  /** What the page was opened with, or what was dropped on it; null where it has no race yet. */
  race(): LoadedRace | null;
  /** Shows the report again that the page was opened with; null while it is shown, or where there is none. */
  backToReport(): (() => void) | null;
  /** Opens the replay with one play, or two beside each other on one clock; from that time on, or the beginning. */
  replay(plays: { play: Play; record: string }[], time?: number, look?: Camera): void;
  /** Opens the maze in Live, or in Draw. */
  live(maze: MazeData): void;
  draw(maze: MazeData): void;
  /** The mazes that were opened in this page, and the one of the drawing. */
  mazes(): MazeData[];
  /** The maze of the drawing, for Live; null while there is none. */
  drawn(): MazeData | null;
  /** Takes files as if they had been dropped, or lets the user choose some. */
  open(files: File[]): void;
  choose(): void;
  /**
   * Takes the results of a race that was held in the page, and says so; who looks at another view is left there. `records`:
   * of contests that cannot be run again.
   */
  hold(results: RaceResults, mazes: MazeData[], message: string, order?: Order, records?: PackedRecord[]): void;
  /** What the browser keeps until the page is opened again. */
  shelf: Shelf;
  /** Keeps what the replay shows, and where it is, as a link has it. */
  keepPlays(plays: { play: Play; record: string }[]): void;
  keepMoment(address: string): void;
  /** Says something to all readers: a status, or what went wrong (with its lines). */
  tell(message: string): void;
  complain(error: unknown): void;
  /** Gives the user a file. */
  save(fileName: string, content: string | Uint8Array<ArrayBuffer>, type?: string): void;
}

/** The page once the core has started. */
export interface Page extends EarlyPage {
  about: About;
}

/** One of the views; built once, shown and hidden. */
export interface View {
  element: HTMLElement;
  /** Called when the view is shown, and when what it shows has changed. */
  shown(): void;
  /** Called when another one is shown. */
  hidden?(): void;
  /** A dropped or linked thing that is for this view. */
  accept?(thing: unknown): void;
  /** The text behind `#` that leads to what is seen now; rejected in words where no link can. */
  address(): Promise<string>;
  /** Goes where that text leads, after `shown`; rejected in words where it leads nowhere. */
  follow?(hash: string): Promise<void>;
  /** The maze that this view holds; null where there is none. A record without a maze is offered it. */
  maze?(): MazeData | null;
}
