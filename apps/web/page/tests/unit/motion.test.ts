import { describe, expect, it } from 'vitest';
import { createPose, poseAt, turnBetween } from '../../src/player/motion';
import { prepare } from '../../src/player/track';
import { mms, steps } from './plays';

const track = prepare(steps());
const at = (frame: number, share: number, of = track) => {
  const pose = createPose();
  poseAt(of, frame, share, pose);
  return [...pose];
};

describe('a pose between two frames', () => {
  it('is that of the frame at its beginning', () => {
    expect(at(2, 0)).toEqual([5, 3, 2]);
    expect(at(8, 0.5)).toEqual([5, 1, 4]);
  });

  it('turns first, then moves', () => {
    const [x, y, heading] = at(1, 0.2);
    expect([x, y]).toEqual([1, 3]);
    expect(heading).toBeGreaterThan(0);
    expect(heading).toBeLessThan(2);
    const [later, , turned] = at(1, 0.9);
    expect(turned).toBe(2);
    expect(later).toBeGreaterThan(3);
    expect(later).toBeLessThan(5);
  });

  it('moves all the time where it does not turn', () => {
    expect(at(0, 0.5)).toEqual([1, 2, 0]);
  });

  it('goes backwards without turning', () => {
    expect(at(3, 0.5)).toEqual([5, 2, 4]);
  });

  it('stays until the end of a reset', () => {
    expect(at(4, 0.99)).toEqual([5, 3, 4]);
    expect(at(3, 0.99, prepare(mms()))).toEqual([2, 4, 1]);
  });

  it('takes all of a step for a turn on the spot', () => {
    const turning = prepare(steps({ x: [1, 1, 1, 1, 1, 1, 1, 1, 1], y: [1, 1, 1, 1, 1, 1, 1, 1, 1] }));
    expect(at(1, 0.5, turning)).toEqual([1, 1, 1]);
  });
});

describe('a turn', () => {
  it('takes the smaller way round', () => {
    expect([turnBetween(0, 6), turnBetween(6, 0), turnBetween(7, 1), turnBetween(1, 7), turnBetween(3, 3)]).toEqual([
      -2, 2, 2, -2, 0,
    ]);
  });
});
