// The home page: who is ahead, how fast time passes, and which way a mouse believes in.
import { describe, expect, it } from 'vitest';
import { gapInWords } from '../../src/home/gap';
import { paceAt } from '../../src/home/pace';
import type { DriveTrack } from '../../src/player/drive';
import { plannedWay } from '../../src/player/paint/plan';
import { createPast } from '../../src/player/past';
import { prepare } from '../../src/player/track';
import { fit, bare } from '../../src/maze/geometry';
import { steps } from './plays';

const standing = (name: string, best: number, left: number) => ({ name, best, left });

describe('the gap', () => {
  it('is in cells before a goal, and in seconds of the best runs after it', () => {
    expect(gapInWords(standing('a', NaN, 7), standing('b', NaN, 4))).toContain('b is 3 cells');
    expect(gapInWords(standing('a', NaN, 5), standing('b', NaN, 4))).toContain('b is 1 cell ');
    expect(gapInWords(standing('a', 9, 0), standing('b', NaN, 4))).toMatch(/^a /);
    expect(gapInWords(standing('a', 9.25, 0), standing('b', 8, 4))).toContain('b leads by 1.250 s');
  });
  it('names nobody where there is none', () => {
    for (const [best, left] of [
      [NaN, 4],
      [8, 4],
    ])
      expect(gapInWords(standing('a', best, left), standing('b', best, left))).not.toMatch(/\b[ab]\b/);
  });
});

describe('the pace', () => {
  const track = (...runs: [string, number, number][]) =>
    ({ runs: runs.map(([kind, begin, end]) => ({ kind, begin: begin * 1e6, end: end * 1e6 })) }) as DriveTrack;
  it('is that of the contest while anybody runs, and quicker while both search', () => {
    const tracks = [track(['search', 0, 10], ['speed', 10, 13]), track(['search', 0, 30])];
    expect(paceAt(tracks, 5)).toBeGreaterThan(1);
    expect(paceAt(tracks, 11)).toBe(1);
    expect(paceAt(tracks, 14)).toBeGreaterThan(1);
  });
});

describe('the way that a mouse believes in', () => {
  const track = prepare(steps());
  const past = createPast(track);
  const g = fit(track.maze, 300, 200, 1, bare);
  it('goes down its beliefs, and through no wall that it knows', () => {
    // Three by two cells: as if the goal at (2,0) were two cells east of the start.
    const beliefs = new Uint16Array(track.cells * (track.last + 1)).fill(65535);
    beliefs.set([2, 1, 0, 3, 2, 1]);
    track.known.fill(0x7fffffff);
    expect(plannedWay({ track, past, beliefs, g })).toEqual([0, 1, 2]);
    track.known.fill(0);
    expect(plannedWay({ track, past, beliefs, g })).not.toEqual([0, 1, 2]);
  });
  it('is none without beliefs', () => expect(plannedWay({ track, past, beliefs: null, g })).toEqual([]));
});
