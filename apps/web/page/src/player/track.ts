// A play as typed arrays, made once, so that nothing is made while it is shown.
import type { MazeData, Play } from '../core/types';
import { closedWalls } from '../maze/geometry';
import { prepareDrive, type DriveTrack } from './drive';
import { mmsChanges, type Changes } from './mms-changes';

export interface Track {
  play: Play;
  maze: MazeData;
  cells: number;
  /** The last frame; there are as many steps. */
  last: number;
  /** When each frame is, as the clock of its world counts; never falling. */
  time: Float64Array;
  /** Half cells and eighths of a turn clockwise from north. */
  x: Int16Array;
  y: Int16Array;
  heading: Int8Array;
  run: Uint8Array;
  /** 1 for a step that puts the mouse back, which is no way through the maze; in seconds for all: see `drive`. */
  jump: Uint8Array;
  /** Steps of each run up to each frame. */
  search: Int32Array;
  speed: Int32Array;
  score: Float64Array;
  closed: Uint8Array;
  /** By wall: the frame from which it is known, `never` for none. */
  known: Int32Array;
  /** What step i entered: enteredCells from enteredFrom[i] to enteredFrom[i + 1]. */
  enteredFrom: Int32Array;
  enteredCells: Int32Array;
  mostVisits: number;
  /** By frame: position of the last reasons then, -1 for none yet. */
  reasons: Int32Array;
  /** What is written at the candidates of each reasons, once it was needed. */
  labels: (string[] | undefined)[];
  /** By frame of the speed run: how many earlier ones are in the same place, of four. */
  fan: Uint8Array;
  changes: Changes;
  /** The first frames of the two marks, and of the speed run; -1 where they never came. */
  goalFrame: number;
  resetFrame: number;
  /** The frame before the first step that falls behind a shortest way; -1 for none. */
  lossFrame: number;
  /** Only in seconds. */
  drive: DriveTrack | null;
}

export const never = 0x7fffffff;

function times(play: Play): Float64Array {
  const time = Float64Array.from(play.clock);
  for (let i = 1; i < time.length; ++i) if (!(time[i] >= time[i - 1])) time[i] = time[i - 1];
  return time;
}

function jumps(play: Play, last: number): Uint8Array {
  const jump = new Uint8Array(last);
  for (let i = 0; i < last; ++i) {
    const straight = play.x[i] === play.x[i + 1] || play.y[i] === play.y[i + 1];
    const crooked = play.traits.clock === 'steps' && !straight;
    jump[i] = play.drive || crooked || /^(ack)?reset/i.test(play.action[i]) ? 1 : 0;
  }
  return jump;
}

/** Steps of that run before each frame. */
function counted(play: Play, last: number, run: number): Int32Array {
  const count = new Int32Array(last + 1);
  for (let i = 0; i < last; ++i) count[i + 1] = count[i] + (play.run[i] === run ? 1 : 0);
  return count;
}

function mostOf(cells: number, entered: Int32Array): number {
  const visits = new Int32Array(cells);
  let most = 0;
  for (const cell of entered) most = Math.max(most, ++visits[cell]);
  return most;
}

function lastReasons(play: Play, last: number): Int32Array {
  const at = new Int32Array(last + 1).fill(-1);
  for (let i = 0; i < play.reasons.length; ++i) if (play.reasons[i].frame <= last) at[play.reasons[i].frame] = i;
  for (let frame = 1; frame <= last; ++frame) if (at[frame] < 0) at[frame] = at[frame - 1];
  return at;
}

/** The frame with which the (first) speed run begins, in worlds that have them. */
const resetOf = (play: Play) => (play.traits.runs.length < 2 ? -1 : (play.reset_frame ?? -1));

function fans(play: Play, last: number): Uint8Array {
  const fan = new Uint8Array(last + 1);
  const stops = new Map<number, number>();
  const reset = resetOf(play);
  if (reset < 0 || play.drive) return fan;
  for (let frame = reset + 1; frame <= last; ++frame) {
    const place = play.y[frame] * (2 * play.maze.width + 1) + play.x[frame];
    const earlier = stops.get(place) ?? 0;
    fan[frame] = earlier % 4;
    stops.set(place, earlier + 1);
  }
  return fan;
}

export function prepare(play: Play): Track {
  const last = play.x.length - 1;
  const cells = play.maze.width * play.maze.height;
  const enteredFrom = new Int32Array(last + 1);
  for (let i = 0; i < last; ++i) enteredFrom[i + 1] = enteredFrom[i] + (play.entered[i]?.length ?? 0);
  const enteredCells = Int32Array.from(play.entered.flat());
  const search = counted(play, last, 0);
  const speed = counted(play, last, 1);
  return {
    play,
    maze: play.maze,
    cells,
    last,
    time: times(play),
    x: Int16Array.from(play.x),
    y: Int16Array.from(play.y),
    heading: Int8Array.from(play.heading),
    run: Uint8Array.from(play.run),
    jump: jumps(play, last),
    search,
    speed,
    score: Float64Array.from(play.scores, (score) => score ?? NaN),
    closed: closedWalls(play.maze),
    known: Int32Array.from(play.known, (frame) => (frame < 0 ? never : frame)),
    enteredFrom,
    enteredCells,
    mostVisits: mostOf(cells, enteredCells),
    reasons: lastReasons(play, last),
    labels: new Array(play.reasons.length),
    fan: fans(play, last),
    changes: mmsChanges(play.events, play.maze, last),
    goalFrame: play.goal_frame ?? -1,
    resetFrame: resetOf(play),
    lossFrame: play.loses.findIndex((lost) => lost > 0),
    drive: play.drive ? prepareDrive(play.drive) : null,
  };
}

/** The last frame at or before that time. */
export function frameAt(track: Track, time: number): number {
  let low = 0;
  let high = track.last;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (track.time[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The score of a contest in steps at that frame; null where it ended without one: then no moment of it had one. */
export const scoreAt = ({ play, score }: Track, frame: number): number | null =>
  play.ended && play.score === null ? null : score[frame];
