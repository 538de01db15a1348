import { describe, expect, it } from 'vitest';
import { colourSlot, mmsLetters, textSlot } from '../../src/player/mms-changes';
import { categoryOf, createPast, knows, moveTo, onwards, speedRun, toGoal } from '../../src/player/past';
import { prepare } from '../../src/player/track';
import type { Play } from '../../src/core/types';
import { mms, steps } from './plays';

/** All that a past has folded, as plain lists. */
const folded = (play: Play, ...frames: number[]) => {
  const past = createPast(prepare(play));
  for (const frame of frames) moveTo(past, frame);
  return { visits: [...past.visits], ways: past.ways.map((way) => [...way]), drawn: [...past.drawn] };
};
const sum = (list: number[]) => list.reduce((a, b) => a + b, 0);

describe('visits', () => {
  it('count up to the frame', () => {
    expect(folded(steps(), 3).visits).toEqual([0, 0, 1, 1, 1, 1]);
    expect(folded(steps(), 8).visits).toEqual([1, 0, 2, 2, 2, 3]);
  });

  it.each([steps(), mms()])('are the same however a frame was reached', (play) => {
    const last = play.x.length - 1;
    for (let frame = 0; frame <= last; ++frame) {
      const straight = folded(play, frame);
      expect(folded(play, last, frame)).toEqual(straight);
      expect(folded(play, 1, last, 0, frame, frame)).toEqual(straight);
    }
  });
});

describe('ways', () => {
  it('are parted by the goal and the reset', () => {
    const track = prepare(steps());
    expect([0, 2, 3, 4, 5, 7].map((step) => categoryOf(track, step))).toEqual([
      toGoal,
      toGoal,
      onwards,
      onwards,
      speedRun,
      speedRun,
    ]);
  });

  it('have a piece for each half cell, whichever way it is gone, and none for a reset', () => {
    const { ways } = folded(steps(), 8);
    expect(ways.map(sum)).toEqual([8, 2, 8]);
    // Up from the start: both pieces that go north from (1,1) and (1,2).
    expect([ways[toGoal][4 * (1 * 7 + 1)], ways[toGoal][4 * (2 * 7 + 1)]]).toEqual([1, 1]);
    // Back north from the goal: the same pieces as the way down to it.
    expect([ways[toGoal][4 * (1 * 7 + 5)], ways[onwards][4 * (1 * 7 + 5)]]).toEqual([1, 1]);
  });

  it('go along diagonals in mms', () => {
    const { ways } = folded(mms(), 4);
    expect(sum(ways[toGoal])).toBe(3);
    expect(ways[toGoal][4 * (3 * 7 + 1) + 1]).toBe(1);
  });

  it('have the same piece of a diagonal, whichever way it is gone', () => {
    const there = mms({ x: [1, 2, 1, 1, 1], y: [2, 1, 2, 2, 2] });
    expect(folded(there, 4).ways[toGoal][4 * (2 * 7 + 1) + 3]).toBe(2);
  });
});

describe('knowledge', () => {
  it('comes with the frame from which a wall is known, and goes again', () => {
    const past = createPast(prepare(steps()));
    const wall = 7;
    const seen = [0, 2, 3, 8, 2].map((frame) => (moveTo(past, frame), knows(past, wall)));
    expect(seen).toEqual([false, false, true, true, false]);
  });

  it('is what was drawn in mms', () => {
    const past = createPast(prepare(mms()));
    expect([1, 2, 3, 4, 0].map((frame) => (moveTo(past, frame), knows(past, 6)))).toEqual([
      false,
      true,
      true,
      false,
      false,
    ]);
  });
});

describe('drawings of mms', () => {
  const at = (frame: number) => {
    const past = createPast(prepare(mms()));
    moveTo(past, frame);
    const colour = (cell: number) => mmsLetters[past.drawn[colourSlot(6, cell)] - 1] ?? '';
    const text = (cell: number) => past.track.changes.rows[past.drawn[textSlot(6, cell)]].join('|');
    return { colours: [0, 1, 2, 3, 4, 5].map(colour).join(','), text: text(4) };
  };

  it('hold until they are cleared', () => {
    expect([0, 1, 2, 3, 4].map((frame) => at(frame).colours)).toEqual([
      'G,,,,,',
      'G,,,,,',
      'G,,,,,',
      ',,,,,k',
      ',,,,,k',
    ]);
  });

  it('have two rows of five characters', () => {
    expect([0, 1, 3, 4].map((frame) => at(frame).text)).toEqual(['', 'abcde|fgh', 'abcde|fgh', '']);
  });

  it('leave out walls of the border that no list has, and colours that mms does not know', () => {
    const events: Play['events'] = [
      { frame: 0, kind: 'wall', cell: [0, 0], side: 'west', there: true },
      { frame: 0, kind: 'colour', cell: [0, 0], colour: '?' },
      { frame: 0, kind: 'colour', cell: [1, 0], colour: '' },
    ];
    expect(prepare(mms({ events })).changes.slot).toHaveLength(0);
  });
});
