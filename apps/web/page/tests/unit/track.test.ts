import { describe, expect, it } from 'vitest';
import { frameAt, never, prepare } from '../../src/player/track';
import { mms, steps } from './plays';

describe('a track', () => {
  it('counts the steps of both runs and the score up to each frame', () => {
    const track = prepare(steps());
    expect([...track.search]).toEqual([0, 1, 2, 3, 4, 5, 5, 5, 5]);
    expect([...track.speed]).toEqual([0, 0, 0, 0, 0, 0, 1, 2, 3]);
    expect(track.score[4]).toBeCloseTo(4 / 30);
    expect(track.score[8]).toBeCloseTo(3 + 5 / 30);
  });

  it('takes the score of mms as it stands', () => {
    expect([...prepare(mms()).score]).toEqual([0, 1, 2, 3, 4]);
  });

  it('finds the frame of a time, also where several have the same', () => {
    const track = prepare(mms());
    expect([-1, 0, 0.4, 0.5, 1.2, 1.25, 9].map((time) => frameAt(track, time))).toEqual([0, 0, 0, 2, 2, 3, 4]);
  });

  it('never lets time fall', () => {
    expect([...prepare(steps({ clock: [0, 1, 5, 3, 4, 6, 7, 8, 9] })).time]).toEqual([0, 1, 5, 5, 5, 6, 7, 8, 9]);
  });

  it('knows which steps put the mouse back', () => {
    expect([...prepare(steps()).jump]).toEqual([0, 0, 0, 0, 1, 0, 0, 0]);
    expect([...prepare(mms()).jump]).toEqual([0, 0, 0, 1]);
  });

  it('has unknown walls as never known, and the closed ones of the maze', () => {
    const track = prepare(steps({ known: [0, -1, 2, 0, 0, 0, -1, 3, 0, 1, 1, 0] }));
    expect(track.known[1]).toBe(never);
    expect(track.known[2]).toBe(2);
    expect([...track.closed]).toEqual([0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0, 1]);
  });

  it('holds the last reasons until the next ones', () => {
    const reasons = (frame: number) => ({ frame, ground: '', candidates: [], chosen: -1, known: 0, hope: 0, price: 0 });
    const track = prepare(steps({ reasons: [reasons(1), reasons(4)] }));
    expect([...track.reasons]).toEqual([-1, 0, 0, 0, 1, 1, 1, 1, 1]);
  });

  it('fans out stops of the speed run in the same place', () => {
    const back = steps({ x: [1, 1, 5, 5, 5, 1, 1, 1, 1], y: [1, 3, 3, 1, 3, 1, 3, 3, 1] });
    expect([...prepare(back).fan]).toEqual([0, 0, 0, 0, 0, 0, 0, 1, 0]);
  });
});
