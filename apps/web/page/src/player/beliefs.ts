// Believed distances, asked of the core once a play.
import type { Core } from '../core/client';
import type { Track } from './track';
import { counted } from './figures';

const mostBytes = 128 * 1024 * 1024;

/** Steps to the goal from each cell, frame by frame, as the mouse believed them. */
export async function fetchBeliefs(core: Core, track: Track): Promise<Uint16Array> {
  const { play, last, cells } = track;
  const frames = last + 1;
  if (2 * frames * cells > mostBytes)
    throw new Error(
      `the believed distances of ${counted(frames, 'frame')} are too many to draw: the limit is ${mostBytes >> 20} MiB`,
    );
  const stride = play.rules?.stride ?? 1;
  const { bytes } = await core.call('beliefs', { maze: track.maze, known: play.known, frames, stride });
  const whole = new Uint8Array(2 * frames * cells);
  whole.set(bytes.subarray(0, whole.length));
  return new Uint16Array(whole.buffer);
}
