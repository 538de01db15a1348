import { describe, expect, it } from 'vitest';
import { framesFor, planFilm } from '../../src/film/plan';
import { SvgContext } from '../../src/maze/svg-context';
import { levelEnd, levels, lossLevel } from '../../src/race/heat-paint';

describe('a film', () => {
  it('shows each step once where there is room, and ends with the end', () => {
    const { times } = planFilm(100, true, 360);
    expect(times).toEqual(Array.from({ length: 101 }, (_, i) => i));
  });
  it('leaves steps out where there are too many, evenly', () => {
    const { times } = planFilm(1000, true, 100);
    expect(times).toHaveLength(101);
    expect([times[0], times[1], times.at(-1)]).toEqual([0, 10, 1000]);
  });
  it('gives speed runs more frames, and goes on steadily', () => {
    const { times } = planFilm(100, false, 360, [
      [90, 95],
      [20, 30],
      [25, 40],
      [99, 120],
    ]);
    expect([times[0], times.at(-1)]).toEqual([0, 100]);
    for (let i = 1; i < times.length; ++i) expect(times[i]).toBeGreaterThan(times[i - 1]);
    const between = (from: number, to: number) =>
      times.filter((time) => time > from && time <= to).length / (to - from);
    expect(between(20, 40)).toBeGreaterThan(3.5 * between(0, 20));
    expect(between(90, 95)).toBeGreaterThan(3.5 * between(50, 90));
  });
  it('has delays in hundredths of a second that every viewer keeps', () => {
    for (const frames of [1, 60, 360, 5000]) {
      const { delay } = planFilm(1e4, false, frames);
      expect(delay % 10).toBe(0);
      expect(delay).toBeGreaterThanOrEqual(20);
    }
  });
  it('has fewer frames in larger mazes, and some in the largest', () => {
    expect(framesFor(256)).toBe(framesFor(100));
    expect(framesFor(1024)).toBeLessThan(framesFor(256));
    expect(framesFor(4096)).toBeGreaterThanOrEqual(60);
  });
  it('of nothing is a still', () => {
    expect(planFilm(0, true, 360).times).toEqual([0, 0]);
  });
});

describe('a drawing in SVG', () => {
  it('keeps text as text, whatever it says', () => {
    const drawn = new SvgContext();
    drawn.font = '600 14px "A & B", sans-serif';
    drawn.fillStyle = '"><script>';
    drawn.fillText('<script>alert("&")</script>', 1, 2);
    const text = drawn.elements();
    expect(text).not.toContain('<script');
    expect(text).toContain('&lt;script>alert(&quot;&amp;&quot;)&lt;/script>');
    expect(text).toContain('font-size="14" font-weight="600"');
  });
  it('puts rectangles of one colour together, in the order of painting', () => {
    const drawn = new SvgContext();
    drawn.fillStyle = 'red';
    drawn.fillRect(0, 0, 1, 1);
    drawn.fillRect(2, 0, 1, 1);
    drawn.fillStyle = 'blue';
    drawn.fillRect(0, 0, 5, 5);
    drawn.beginPath();
    drawn.moveTo(0, 0);
    drawn.lineTo(3, 4);
    drawn.stroke();
    expect(
      drawn
        .elements()
        .split('\n')
        .map((one) => /fill="(\w+)"/.exec(one)![1]),
    ).toEqual(['red', 'blue', 'none']);
  });
});

it('the tones of a heat map are for all losses from next to nothing to the most', () => {
  expect([lossLevel(0, 5), lossLevel(1e-9, 5), lossLevel(5, 5), lossLevel(0, 0)]).toEqual([0, 1, levels, 0]);
  for (let level = 1; level <= levels; ++level) expect(lossLevel(levelEnd(level, 5), 5)).toBe(level);
  // Those of little loss are narrow: half of them are for less than a quarter of the most.
  expect(levelEnd(levels / 2, 8)).toBe(2);
});
