// Both mice of a contest in the physical world, at a moment and on a canvas that only notes what is drawn.
import { describe, expect, it } from 'vitest';
import type { DriveBodies } from '../../src/core/types';
import { fit, halfX, halfY } from '../../src/maze/geometry';
import type { Context } from '../../src/maze/painter';
import type { Palette } from '../../src/maze/palette';
import { createMoment, goTo, prepareDrive } from '../../src/player/drive';
import { has } from '../../src/player/layers';
import { createPose } from '../../src/player/motion';
import { beliefAt, lastBy, paintBodies } from '../../src/player/paint/bodies';
import type { Brush } from '../../src/player/paint/brush';
import { seconds } from './plays';

/** A tenth of a cell east of the true mouse, and a touch in each run. */
function bodies(changes: Partial<DriveBodies> = {}): DriveBodies {
  const { path } = seconds().drive!;
  return {
    front: 0.3,
    back: 0.2,
    half_width: 0.2,
    rounding: 0.05,
    belief: { x: path.x.map((x) => x + 0.1), y: path.y, heading: path.heading },
    beams: [{ ahead: 0.1, left: -0.1, angle: 2 }],
    distances: path.t.map((_, i) => (i === 0 ? 0 : 0.25)),
    looks: [
      { time: 1e6, x: 0, y: 1, heading: 0, evidence: [64, -64, 0] },
      { time: 2e6, x: 1, y: 1, heading: 2, evidence: [64, 64, 64] },
    ],
    touches: [
      { time: 1.5e6, x: 1, y: 1, crash: false },
      { time: 5.2e6, x: 0.5, y: 2, crash: true },
    ],
    ...changes,
  };
}

function at(time: number, more = bodies()) {
  const drive = prepareDrive({ ...seconds().drive!, bodies: more });
  const moment = createMoment();
  goTo(drive, time, moment);
  return { drive, moment, bodies: more };
}

describe('where the mouse believes to be', () => {
  it('lies between two points as the time does', () => {
    const { drive, moment, bodies: own } = at(0.25);
    const pose = createPose();
    expect(beliefAt(drive, own, moment, pose)).toBe(true);
    expect([...pose]).toEqual([expect.closeTo(1.2), expect.closeTo(1.5), 0]);
  });

  it('is unknown of a program that does not tell', () => {
    const { drive, moment, bodies: own } = at(0.25, bodies({ belief: { x: [], y: [], heading: [] } }));
    expect(beliefAt(drive, own, moment, createPose())).toBe(false);
  });
});

it('what was read and touched is the last by then', () => {
  const { looks } = bodies();
  expect(lastBy(looks, at(0.5).moment)).toBe(-1);
  expect(lastBy(looks, at(1.5).moment)).toBe(0);
  expect(lastBy(looks, at(9).moment)).toBe(1);
});

/** What is stroked, with the dashes and the place of the mouse that it belongs to. */
function painted(time: number, more = bodies()) {
  const { drive, moment } = at(time, more);
  const g = fit(seconds().maze, 400, 400, 1, { left: 0, bottom: 0 });
  const strokes: { dashed: boolean; place: number[]; lines: number; outline: boolean }[] = [];
  let dashed = false;
  let place: number[] = [];
  let lines = 0;
  let outline = false;
  const context = {
    setLineDash: (dash: number[]) => (dashed = dash.length > 0),
    setTransform: (...matrix: number[]) => (place = matrix.slice(4)),
    beginPath: () => {
      lines = 0;
      outline = false;
    },
    roundRect: () => (outline = true),
    moveTo: () => undefined,
    lineTo: () => ++lines,
    stroke: () => strokes.push({ dashed, place, lines, outline }),
  } as unknown as Context;
  const brush = { context, g, palette: {} as Palette, track: { drive }, hue: 'ink' } as unknown as Brush;
  paintBodies(brush, moment);
  return { g, strokes, moment };
}

describe('the painted bodies', () => {
  it('are two, the believed one dashed beside the true one', () => {
    const { g, strokes, moment } = painted(0.25);
    const outlines = strokes.filter(({ outline }) => outline);
    expect(outlines.map(({ dashed }) => dashed)).toEqual([false, true]);
    expect(outlines[0].place).toEqual([halfX(g, 2 * moment.x), halfY(g, 2 * moment.y)]);
    expect(outlines[1].place[0] - outlines[0].place[0]).toBeCloseTo(0.1 * g.pitch);
  });

  it('are one where nobody knows the other', () => {
    const { strokes } = painted(0.25, bodies({ belief: { x: [], y: [], heading: [] } }));
    expect(strokes.filter(({ outline }) => outline)).toHaveLength(1);
  });

  it('have the evidence of the last cell, where there is some', () => {
    const bars = (time: number) =>
      painted(time, bodies({ beams: [], touches: [] })).strokes.filter(({ lines }) => lines === 1);
    expect(bars(0.5)).toHaveLength(0);
    expect(bars(1.5)).toHaveLength(2);
    expect(bars(2.5)).toHaveLength(3);
  });

  it('have the touches of their run', () => {
    const crosses = (time: number) => painted(time, bodies({ looks: [] })).strokes.filter(({ lines }) => lines === 2);
    expect(crosses(1)).toHaveLength(0);
    expect(crosses(2)).toHaveLength(1);
    // The next run begins without them.
    expect(crosses(4)).toHaveLength(0);
    expect(crosses(5.4)).toHaveLength(1);
  });
});

it('the layer of rays is theirs', () => {
  const play = seconds();
  expect(has(play, 'rays')).toBe(false);
  expect(has({ ...play, drive: { ...play.drive!, bodies: bodies() } }, 'rays')).toBe(true);
});
