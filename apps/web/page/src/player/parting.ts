// Where two walks in one maze part.
import type { Play } from '../core/types';

type Walk = Pick<Play, 'x' | 'y' | 'heading' | 'action'>;

export interface Parting {
  /** The last frame in which both have done the same: the step after it is the first that differs, counted from 1. */
  frame: number;
  /** The cell in which both are then. */
  cell: [x: number, y: number];
  /** What each does in that step; null where its walk is over. */
  actions: [string | null, string | null];
}

/** The first step that leads two mice to different places or headings, or that only one of them makes; null for none. */
export function partingOf(one: Walk, other: Walk): Parting | null {
  const same = (i: number) =>
    one.x[i] === other.x[i] && one.y[i] === other.y[i] && (one.heading[i] - other.heading[i]) % 8 === 0;
  const last = Math.min(one.action.length, other.action.length);
  let frame = 0;
  while (frame < last && same(frame + 1)) ++frame;
  if (frame === one.action.length && frame === other.action.length) return null;
  const half = (value: number) => Math.floor(value / 2);
  const action = (walk: Walk) => walk.action[frame] ?? null;
  return { frame, cell: [half(one.x[frame]), half(one.y[frame])], actions: [action(one), action(other)] };
}
