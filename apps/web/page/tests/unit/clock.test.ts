import { describe, expect, it } from 'vitest';
import { createClock, rateOf, seek, speeds, start, tick } from '../../src/player/clock';

const running = (changes = {}) => {
  const clock = { ...createClock(), end: 10, ...changes };
  start(clock);
  tick(clock, 1000);
  return clock;
};

describe('a clock', () => {
  it('goes on by the rate', () => {
    const clock = running({ speed: speeds.indexOf(2) });
    tick(clock, 1050);
    expect(clock.time).toBeCloseTo(0.05 * 8);
  });

  it('stands while it is paused', () => {
    const clock = running();
    clock.playing = false;
    tick(clock, 1090);
    expect(clock.time).toBe(0);
  });

  it('does not leap after the browser slept', () => {
    const clock = running();
    tick(clock, 60_000);
    expect(clock.time).toBeCloseTo(0.4);
  });

  it('stops at the end, or begins again', () => {
    const once = running({ time: 9.9 });
    tick(once, 1090);
    expect([once.time, once.playing]).toEqual([10, false]);
    const again = running({ time: 9.9, loop: true });
    tick(again, 1090);
    expect([again.time, again.playing]).toEqual([0, true]);
  });

  it('starts from the beginning where it stands at the end', () => {
    expect(running({ time: 10 }).time).toBe(0);
  });

  it('fits all of it into 20 seconds', () => {
    expect(rateOf({ ...createClock(), end: 4000, speed: -1 })).toBe(200);
  });

  it('stays within the replay', () => {
    const clock = running();
    seek(clock, 99);
    expect(clock.time).toBe(10);
    seek(clock, -1);
    expect(clock.time).toBe(0);
  });
});
