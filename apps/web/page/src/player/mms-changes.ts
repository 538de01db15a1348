// What a program for mms drew, as changes that can be made and undone.
import type { MazeData, MmsEvent } from '../core/types';
import { wallIndex } from '../maze/geometry';

/** The letters of mms's colours, in its order; the state of a cell is their position + 1. */
export const mmsLetters = 'kbacgorwyBCAGORVY';

/**
 * A drawing is one number for each slot: walls (as in lists over walls; 1 where one was drawn), then the colour of each
 * cell (a position in mmsLetters + 1), then its text (a position in `rows`). Change i sets its slot from `before` to
 * `after`; `end[frame]` changes have been made by that frame.
 */
export interface Changes {
  slots: number;
  slot: Int32Array;
  before: Int32Array;
  after: Int32Array;
  end: Int32Array;
  /** The texts in the rows of five characters that mms shows, two at most; the first is the empty one. */
  rows: string[][];
}

export const colourSlot = (cells: number, cell: number) => 2 * cells + cell;
export const textSlot = (cells: number, cell: number) => 3 * cells + cell;

const rowsOf = (text: string) => [text.slice(0, 5), text.slice(5, 10)].filter((row) => row !== '');

/** Positions of texts, each once. */
function textTable() {
  const rows: string[][] = [[]];
  const places = new Map([['', 0]]);
  const place = (text: string) => {
    const known = places.get(text);
    if (known !== undefined) return known;
    places.set(text, rows.length);
    return rows.push(rowsOf(text)) - 1;
  };
  return { rows, place };
}

export function mmsChanges(events: MmsEvent[], maze: MazeData, last: number): Changes {
  const cells = maze.width * maze.height;
  const state = new Int32Array(4 * cells);
  const log: number[] = [];
  const end = new Int32Array(last + 1);
  const { rows, place } = textTable();
  // The slots that a clearing may have to empty, so that it need not look at all.
  const coloured = new Set<number>();
  const written = new Set<number>();

  function set(slot: number, value: number) {
    if (state[slot] === value) return;
    log.push(slot, state[slot], value);
    state[slot] = value;
  }
  function clear(slots: Set<number>) {
    for (const slot of slots) set(slot, 0);
    slots.clear();
  }
  function make(event: MmsEvent) {
    if (event.kind === 'clear colours') return clear(coloured);
    if (event.kind === 'clear texts') return clear(written);
    const cell = event.cell[1] * maze.width + event.cell[0];
    if (event.kind === 'wall') {
      const wall = wallIndex(maze, event.cell, event.side);
      return wall < 0 ? undefined : set(wall, event.there ? 1 : 0);
    }
    const slot = event.kind === 'colour' ? colourSlot(cells, cell) : textSlot(cells, cell);
    (event.kind === 'colour' ? coloured : written).add(slot);
    const colour = event.kind === 'colour' && event.colour !== '' ? mmsLetters.indexOf(event.colour) + 1 : 0;
    set(slot, event.kind === 'colour' ? colour : place(event.text));
  }

  let next = 0;
  for (let frame = 0; frame <= last; ++frame) {
    for (; next < events.length && events[next].frame <= frame; ++next) make(events[next]);
    end[frame] = log.length / 3;
  }
  const column = (offset: number) => Int32Array.from({ length: log.length / 3 }, (_, i) => log[3 * i + offset]);
  return { slots: 4 * cells, slot: column(0), before: column(1), after: column(2), end, rows };
}
