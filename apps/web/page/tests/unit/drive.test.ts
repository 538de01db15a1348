import { describe, expect, it } from 'vitest';
import { curveData } from '../../src/player/curves';
import {
  createMoment,
  endText,
  followsRoute,
  gateToGate,
  goTo,
  madeOf,
  prepareDrive,
  runAt,
} from '../../src/player/drive';
import { has, layerNames } from '../../src/player/layers';
import { createPast, knows, moveTo } from '../../src/player/past';
import { speedLevel } from '../../src/player/paint/drive';
import { prepare } from '../../src/player/track';
import { seconds, steps } from './plays';

const track = () => prepareDrive(seconds().drive!);
function at(time: number) {
  const moment = createMoment();
  goTo(track(), time, moment);
  return moment;
}

describe('a moment in seconds', () => {
  it('is driven evenly where the speed is even', () => {
    expect(at(0.25)).toMatchObject({ run: 0, point: 0, x: 0.5, y: 0.75, heading: 0, v: 0.1, a: 0 });
  });

  it('has gone a quarter of the way in half the time from rest', () => {
    const { y, v, a } = at(4);
    expect([y, v, a]).toEqual([0.75, expect.closeTo(0.05), expect.closeTo(0.05)]);
  });

  it('has gone three quarters of the way in half the time to rest', () => {
    expect([at(1.5).x, at(1.5).v]).toEqual([expect.closeTo(1.25), expect.closeTo(0.05)]);
  });

  it('turns on the spot, where there is no way', () => {
    expect(at(2.5)).toMatchObject({ x: 1.5, y: 1.5, heading: 4, v: 0 });
  });

  it('is in the later run, and at the later speed, where both are at one time', () => {
    expect(at(3)).toMatchObject({ run: 1, x: 0.5, y: 0.5, v: 0 });
    expect(at(5)).toMatchObject({ run: 1, point: 6, v: 0.2 });
  });

  it('stays at the end', () => {
    expect(at(99)).toMatchObject({ run: 1, point: 7, y: 2 });
  });

  it('is nowhere without runs', () => {
    const { drive } = seconds();
    const none = prepareDrive({ ...drive!, runs: [], path: drive!.best });
    expect(runAt(none, 1)).toBe(-1);
    const moment = createMoment();
    goTo(none, 1, moment);
    expect(moment.point).toBe(-1);
    expect(none.fastest).toBeGreaterThan(0);
  });
});

describe('a run', () => {
  it('has its gates and its value', () => {
    const { drive } = seconds();
    expect(drive!.runs.map(gateToGate)).toEqual([1e6, 1.5e6]);
    expect(madeOf(drive!.runs[1], drive!.rules)).toBe('1.500 s + 0.100 s for 3 s / 30');
    expect(madeOf(drive!.runs[0], drive!.rules)).toBe('');
  });

  it('of laps has the time of the fastest one', () => {
    const [, fast] = seconds().drive!.runs;
    const laps = { ...fast, kind: 'laps' as const, gate_in: null, laps: [6e6, 7.5e6], ended: 'done' };
    expect(gateToGate(laps)).toBe(1.5e6);
    expect(gateToGate({ ...laps, laps: [], score: null })).toBeNull();
    expect(endText(laps)).toBe('2 laps');
    expect([laps, fast, seconds().drive!.runs[0], undefined].map(followsRoute)).toEqual([true, true, false, false]);
  });

  it('has curves over its own time', () => {
    const [time, speed, acceleration] = curveData(track(), 1);
    expect(time).toEqual([0, 2, 2, 2.5]);
    expect(speed).toEqual([0, 0.1, 0.2, 0.2]);
    expect(acceleration).toEqual([0.05, 0, 0, 0]);
  });
});

describe('speeds', () => {
  it('have tones from rest to the fastest', () => {
    expect([0, 0.99, 1, 3, 5.99, 6, 7].map((speed) => speedLevel(speed, 6, 6))).toEqual([0, 0, 1, 3, 5, 5, 5]);
  });
});

describe('a play in seconds', () => {
  it('has frames, walls and visits as the others', () => {
    const play = seconds();
    const past = createPast(prepare(play));
    expect(knows(past, 7)).toBe(false);
    moveTo(past, 1);
    expect(knows(past, 7)).toBe(true);
    moveTo(past, 5);
    expect([...past.visits]).toEqual([0, 0, 0, 2, 1, 0]);
    moveTo(past, 0);
    expect(past.visits.every((visits) => visits === 0)).toBe(true);
  });

  it('has no layers that only steps have', () => {
    const off = layerNames.filter((layer) => has(steps(), layer) && !has(seconds(), layer));
    expect(off).toEqual(['rays', 'search', 'best']);
    const { drive } = seconds();
    expect(has(seconds({ drive: { ...drive!, best: drive!.path } }), 'best')).toBe(true);
  });

  it('has no score before its first run', () => {
    expect([...prepare(seconds()).score]).toEqual([NaN, NaN, NaN, NaN, NaN, 1.5]);
  });
});
