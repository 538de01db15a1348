// What a player shows at the moment, and what its parts may do to it.
import { isSameMaze } from '../maze/same';
import type { Tone } from '../maze/palette';
import type { Clock } from './clock';
import type { Layers } from './layers';
import type { Scene } from './scene';
import type { Track } from './track';

/** One of the contests that are shown. */
export interface Side {
  record: string;
  /** Of the mouse; beside another play of the same mouse with what tells them apart. */
  name: string;
  track: Track;
  scene: Scene;
  /** The tone of its mouse. */
  hue: Tone;
}

export interface State {
  clock: Clock;
  layers: Layers;
  sides: Side[];
  /** The one whose steps and reasons are listed. */
  chosen: number;
  /** The panel is out of the way of the picture. */
  folded: boolean;
}

/** `loss`: the first step that falls behind a shortest way. */
export type Mark = 'start' | 'goal' | 'speed' | 'end' | 'loss';

export interface Actions {
  toggle(): void;
  /** By so many frames of any of the sides. */
  step(by: number): void;
  seek(time: number): void;
  jump(mark: Mark): void;
  /** A position in `speeds`, -1 to fit. */
  setSpeed(speed: number): void;
  setLoop(loop: boolean): void;
  setLayers(layers: Partial<Layers>): void;
  choose(side: number): void;
  /** So many steps nearer or, below 0, farther; 0 shows the whole maze. */
  zoom(by: number): void;
  /** So many steps to the right and down. */
  pan(x: number, y: number): void;
  /** Puts the panel away, or back. */
  fold(): void;
  /** To the full screen, or back. */
  enlarge(): void;
}

/**
 * What a part of the player beside its pictures is made from: after the frame has changed, some times a second while it
 * plays, and with anything else that has changed.
 */
export interface PanelProps {
  state: State;
  actions: Actions;
}

/** Whether the steps and the scores of two contests mean the same; those of two worlds, or of two mazes, do not. */
export const isComparable = (sides: Side[]): boolean =>
  sides.length === 2 &&
  sides[0].track.play.world === sides[1].track.play.world &&
  isSameMaze(sides[0].track.play, sides[1].track.play);

/** When that mark is in a contest; null where it never comes. */
export function timeOf({ track }: Side, mark: Mark): number | null {
  if (mark === 'start') return 0;
  if (mark === 'end') return track.time[track.last];
  const frame = { goal: track.goalFrame, speed: track.resetFrame, loss: track.lossFrame }[mark];
  return frame < 0 ? null : track.time[frame];
}

/** The time of the frame that is next after that time (or before it) in any of them. */
export function nextTime(sides: Side[], time: number, forwards: boolean): number {
  let next = forwards ? Infinity : -Infinity;
  for (const { track } of sides) {
    const at = frameAfter(track, time, forwards);
    if (at >= 0 && at <= track.last) next = forwards ? Math.min(next, track.time[at]) : Math.max(next, track.time[at]);
  }
  return Number.isFinite(next) ? next : time;
}

/** The first frame after that time, or the last before it; one past the ends where there is none. */
function frameAfter({ time, last }: Track, now: number, forwards: boolean): number {
  let low = -1;
  let high = last + 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (forwards ? time[middle] <= now : time[middle] < now) low = middle;
    else high = middle;
  }
  return forwards ? high : low;
}
