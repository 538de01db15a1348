// What has happened up to a frame: visits, ways and drawings, each folded on forwards and undone backwards.
import { directionOf, waySlots } from './ways';
import type { Track } from './track';

/** Categories of ways; those of the search run are parted by the first frame in the goal. */
export const toGoal = 0;
export const onwards = 1;
export const speedRun = 2;

export interface Past {
  track: Track;
  frame: number;
  visits: Int32Array;
  /** How often each piece of a way was gone, by category: see ways.ts for its places. */
  ways: Int32Array[];
  /** See mms-changes.ts. */
  drawn: Int32Array;
}

export function createPast(track: Track): Past {
  const pieces = waySlots(track.maze);
  const past = {
    track,
    frame: 0,
    visits: new Int32Array(track.cells),
    ways: [new Int32Array(pieces), new Int32Array(pieces), new Int32Array(pieces)],
    drawn: new Int32Array(track.changes.slots),
  };
  draw(past, 0, track.changes.end[0]);
  return past;
}

export function categoryOf(track: Track, step: number): number {
  if (track.run[step] === 1) return speedRun;
  return track.goalFrame >= 0 && step >= track.goalFrame ? onwards : toGoal;
}

function countVisits({ track, visits }: Past, step: number, by: number) {
  for (let i = track.enteredFrom[step]; i < track.enteredFrom[step + 1]; ++i) visits[track.enteredCells[i]] += by;
}

/** The way of a step, piece by piece: half a cell each, or half its diagonal. */
function countWay({ track, ways }: Past, step: number, by: number) {
  if (track.jump[step] !== 0) return;
  const counts = ways[categoryOf(track, step)];
  let x = track.x[step];
  let y = track.y[step];
  const dx = Math.sign(track.x[step + 1] - x);
  const dy = Math.sign(track.y[step + 1] - y);
  const pieces = Math.max(Math.abs(track.x[step + 1] - x), Math.abs(track.y[step + 1] - y));
  const wide = 2 * track.maze.width + 1;
  for (let i = 0; i < pieces; ++i, x += dx, y += dy) {
    const back = dx < 0 || (dx === 0 && dy < 0);
    const begin = back ? (y + dy) * wide + x + dx : y * wide + x;
    counts[4 * begin + directionOf(back ? -dx : dx, back ? -dy : dy)] += by;
  }
}

function draw({ track: { changes }, drawn }: Past, from: number, to: number) {
  for (let i = from; i < to; ++i) drawn[changes.slot[i]] = changes.after[i];
  for (let i = from - 1; i >= to; --i) drawn[changes.slot[i]] = changes.before[i];
}

/** Goes to that frame, forwards or backwards. */
export function moveTo(past: Past, frame: number) {
  const { track } = past;
  const { end } = track.changes;
  for (let step = past.frame; step < frame; ++step) {
    countVisits(past, step, 1);
    countWay(past, step, 1);
  }
  for (let step = past.frame - 1; step >= frame; --step) {
    countVisits(past, step, -1);
    countWay(past, step, -1);
  }
  draw(past, end[past.frame], end[frame]);
  past.frame = frame;
}

/** Whether the mouse knows that wall at that frame; where its map is what it draws, whether it drew it. */
export function knows(past: Past, wall: number): boolean {
  return past.track.play.traits.draws ? past.drawn[wall] !== 0 : past.track.known[wall] <= past.frame;
}
