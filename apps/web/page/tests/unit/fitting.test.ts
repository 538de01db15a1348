// @vitest-environment happy-dom
// Text that has to fit into a width: what fits, and how little is measured for that.
import type uPlot from 'uplot';
import { expect, it } from 'vitest';
import { nameLines } from '../../src/race/line-names';
import { fitting } from '../../src/ui/fitting';

/** A context in which each sign is a pixel wide, and which counts what it measures. */
function measuring() {
  const counted = { calls: 0, signs: 0 };
  const measureText = (text: string) => {
    counted.calls += 1;
    counted.signs += text.length;
    return { width: text.length } as TextMetrics;
  };
  return { counted, measureText };
}

it('a text that fits stays whole, and any other is cut as late as can be', () => {
  const text = 'abcdefghijklm';
  for (let width = 0; width < 20; ++width)
    for (let length = 0; length <= text.length; ++length) {
      const whole = text.slice(0, length);
      const cut = fitting(measuring(), whole, width);
      if (length <= width || length < 2) expect(cut).toBe(whole);
      else expect(cut).toBe(`${whole.slice(0, Math.max(1, width - 1))}…`);
    }
});

it('of a name of 10,000 letters no more is measured than what fits needs', () => {
  const context = measuring();
  expect(fitting(context, 'x'.repeat(10_000), 100)).toHaveLength(100);
  expect(context.counted.calls).toBeLessThan(20);
  expect(context.counted.signs).toBeLessThan(2000);
});

it('nor for the names of lines', () => {
  const context = measuring();
  const written: string[] = [];
  const ctx = new Proxy({} as Record<string | symbol, unknown>, {
    get: (set, name) => {
      if (name === 'measureText') return context.measureText;
      if (name === 'fillText') return (text: string) => written.push(text);
      return set[name] ?? (() => undefined);
    },
  });
  const data = [[0], [1], [2]];
  const plot = { ctx, bbox: { left: 0, top: 0, width: 300, height: 100 }, data, valToPos: () => 1 };
  nameLines(plot as unknown as uPlot, ['x'.repeat(10_000), 'short'], ['a', 'b'], 114);
  expect(written.map((text) => text.length)).toEqual([100, 5]);
  expect(context.counted.signs).toBeLessThan(2000);
});
