import { describe, expect, it } from 'vitest';
import { addressOf, longestLink, readAddress, type Moment } from '../../src/link/address';

const nothing: Moment = { mice: [], builtin: [], mazes: [], seeds: [] };

describe('a moment in a link', () => {
  it('comes back as it was', () => {
    const moment: Moment = {
      mice: ['phases:weights=1/5/2:ties=alrb', 'a&b=#c %41 ä<b>'],
      builtin: [],
      mazes: ['1.4x2.ABn.AA.4A.corridor.-hhrkD', 'a-Z_0.9'],
      seeds: [7, Number.MAX_SAFE_INTEGER],
      budget: 500,
      runs: 20,
      robot: 'mm2021',
      rules: 'all-japan',
      vary: { key: 'curve.lateral_acceleration', from: 4000, to: 16000.5 },
      and: { key: 'straight.speed', from: 0, to: 0.000001 },
      pair: 2,
      time: 12.345,
      look: { scale: 2.5, x: 8, y: 7.125 },
    };
    expect(readAddress(`#${addressOf('replay', moment)}`)).toEqual({ view: 'replay', moment });
  });
  it('is short where the maze is built in', () => {
    const text = addressOf('replay', {
      mice: ['certify', 'flood'],
      builtin: ['contest-02'],
      seeds: [1],
      robot: 'classic',
      rules: 'all-japan',
      time: 12.5,
      look: { scale: 2, x: 8, y: 8 },
    });
    expect(text.length).toBeLessThan(120);
    expect(text).toMatch(/^[\w&=.,:/-]+$/);
  });
  it('leaves out what is not said, and a look at the whole maze', () => {
    expect(addressOf('live', {})).toBe('live');
    expect(addressOf('draw', { look: { scale: 1, x: 8, y: 8 } })).toBe('draw');
    expect(readAddress('#live')).toEqual({ view: 'live', moment: nothing });
  });
  it('writes tiny numbers in digits, which it can read again', () => {
    expect(readAddress(addressOf('replay', { time: 1e-9 })).moment.time).toBe(0);
  });
});

describe('a link that is none', () => {
  const refused = (text: string) => {
    try {
      readAddress(text);
    } catch (error) {
      return (error as Error).message;
    }
    return null;
  };
  it.each([
    ...['live&sed=1', 'live&seed', 'live&', 'live&=3', 'live&__proto__=1', 'live&constructor=1', 'live&fields=1'],
    ...['live&mouse=', 'live&mouse=a%4', 'live&seed=-1', 'live&seed=1e3', 'live&seed=9007199254740993', 'live&seed=x'],
    ...['live&budget=0', 'live&budget=1000001', 'live&seed=1&seed=2', 'race&runs=101', 'race&seed=1.5'],
    ...['replay&at=-3', 'replay&at=NaN', 'replay&at=1e9', 'replay&at=9999999999', 'replay&at=Infinity'],
    ...['robot&vary=', 'robot&vary=a', 'robot&vary=a,1', 'robot&vary=a,1,2,3', 'robot&and=a,1,-2', 'robot&vary=a,x,2'],
    ...['replay&zoom=2', 'replay&zoom=0.5,1,1', 'replay&zoom=101,1,1', 'replay&zoom=2,-1,1', 'replay&zoom=2,1,2000'],
  ])('is refused in one line: %s', (text) => {
    expect(refused(text)).toMatch(/^.{10,200}$/);
  });
  it('is refused where it says too much', () => {
    for (const text of [
      `live&mouse=${'a'.repeat(2001)}`,
      `race&in=${'a,'.repeat(900)}`,
      `race${'&mouse=a'.repeat(501)}`,
      `live&mouse=${'a'.repeat(longestLink)}`,
    ])
      expect(refused(text)).toMatch(/^.{10,200}$/);
  });
  it('is not made either', () => {
    expect(() => addressOf('race', { mazes: Array(300).fill('x'.repeat(150)) })).toThrow();
  });
});
