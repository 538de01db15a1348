// Where the mouse is between two frames: it turns, then it moves.
import type { Track } from './track';

/** x and y in half cells, heading in eighths of a turn; numbers in place, so that none is made anew. */
export type Pose = Float64Array;

export const createPose = (): Pose => new Float64Array(3);

/** The share of a step that a turn takes, where there is also a movement. */
const turnShare = 0.35;

const eased = (share: number) => share * share * (3 - 2 * share);

/** The smaller way round, in eighths: -4 to 4. */
export function turnBetween(from: number, to: number): number {
  const turn = (((to - from) % 8) + 8) % 8;
  return turn > 4 ? turn - 8 : turn;
}

/** Writes the pose at a share (0 to 1) of the step after that frame. */
export function poseAt(track: Track, frame: number, share: number, pose: Pose) {
  const { x, y, heading, jump, last } = track;
  pose[0] = x[frame];
  pose[1] = y[frame];
  pose[2] = heading[frame];
  if (frame >= last || share <= 0 || jump[frame] !== 0) return;
  const turn = turnBetween(heading[frame], heading[frame + 1]);
  const moves = x[frame] !== x[frame + 1] || y[frame] !== y[frame + 1];
  const turning = turn === 0 ? 0 : moves ? turnShare : 1;
  if (share < turning) {
    pose[2] += turn * eased(share / turning);
    return;
  }
  pose[2] += turn;
  if (!moves) return;
  const moved = (share - turning) / (1 - turning);
  pose[0] += (x[frame + 1] - x[frame]) * moved;
  pose[1] += (y[frame + 1] - y[frame]) * moved;
}
