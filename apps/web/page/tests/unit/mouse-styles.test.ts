// The tones of mice: apart for everybody, on both grounds; and their names, beside the ends of their lines.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { spread } from '../../src/race/line-names';
import { styleOf } from '../../src/race/mouse-styles';

const sheet = (name: string) =>
  readFileSync(fileURLToPath(new URL(`../../src/styles/${name}.css`, import.meta.url)), 'utf8');
const pairsOf = (css: string, name: string) =>
  [...css.matchAll(new RegExp(`--${name}\\d: light-dark\\((#\\w{6}), (#\\w{6})\\)`, 'g'))].map(([, light, dark]) => [
    light,
    dark,
  ]);
const paper = [/--paper: light-dark\((#\w{6}), (#\w{6})\)/.exec(sheet('page'))!].flatMap(([, light, dark]) => [
  light,
  dark,
]);

type Triple = [number, number, number];
const linear = (hex: string) =>
  [1, 3, 5].map((at) => {
    const value = parseInt(hex.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  }) as Triple;
/** Machado, Oliveira and Fernandes 2009: all of the sight of green, of red, and of blue missing. */
const sights: Triple[][] = [
  [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
];
const times = (rows: Triple[], [r, g, b]: Triple) => rows.map(([x, y, z]) => x * r + y * g + z * b) as Triple;
const clip = (colour: Triple) => colour.map((one) => Math.min(1, Math.max(0, one))) as Triple;
function lab(colour: Triple): Triple {
  const [x, y, z] = times(
    [
      [0.4339, 0.3762, 0.1899],
      [0.2126, 0.7152, 0.0722],
      [0.0177, 0.1095, 0.8729],
    ],
    colour,
  ).map((one) => (one > 0.008856 ? Math.cbrt(one) : 7.787 * one + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const apart = (one: string, other: string) =>
  Math.min(
    ...sights.map((sight) => {
      const [a, b] = [one, other].map((hex) => lab(clip(times(sight, linear(hex)))));
      return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }),
  );
const luminance = (hex: string) => 0.2126 * linear(hex)[0] + 0.7152 * linear(hex)[1] + 0.0722 * linear(hex)[2];
const contrast = (one: string, other: string) => {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
};

describe.each([
  ['light', 0, 44],
  ['dark', 1, 48],
])('on a %s ground', (_, theme, least) => {
  const mice = pairsOf(sheet('race'), 'mouse').map((pair) => pair[theme]);
  it('the tones of mice are told apart by everybody, and from the ground', () => {
    expect(mice).toHaveLength(5);
    for (const [i, one] of mice.entries()) {
      expect(contrast(one, paper[theme]), one).toBeGreaterThan(3);
      for (const other of mice.slice(i + 1)) expect(apart(one, other), `${one} ${other}`).toBeGreaterThan(least);
    }
  });
  it('the classes of the matrix are told apart by everybody, and grow away from the ground', () => {
    const classes = pairsOf(sheet('race'), 'ratio').map((pair) => pair[theme]);
    for (const [i, one] of classes.slice(1).entries()) {
      expect(apart(classes[i], one), `${classes[i]} ${one}`).toBeGreaterThan(9);
      expect(contrast(one, paper[theme])).toBeGreaterThan(contrast(classes[i], paper[theme]));
    }
  });
});

describe('twenty mice', () => {
  it('have twenty looks', () => {
    const looks = Array.from({ length: 20 }, (_, mouse) => styleOf(mouse));
    expect(new Set(looks.map((look) => JSON.stringify(look))).size).toBe(20);
    expect(new Set(looks.map(({ tone }) => tone)).size).toBe(5);
    expect(new Set(looks.map(({ dash }) => dash.join())).size).toBe(4);
  });
  it('are named on places of their own, in the order of their lines', () => {
    expect(spread([50, 20, 21], 0, 100, 10)).toEqual([50, 20, 30]);
    expect(spread([98, 99, 100], 0, 100, 10)).toEqual([80, 90, 100]);
  });
});
