import { expect, it } from 'vitest';
import { addressOf, readAddress } from '../../src/live/address';

it('reads what it wrote', () => {
  const address = { mouse: 'phases:weights=1/5/2:ties=alrb', maze: 'a-Z_0.9', seed: 7, budget: 500 };
  expect(addressOf(address)).toBe('live&mouse=phases:weights=1/5/2:ties=alrb&maze=a-Z_0.9&seed=7&budget=500');
  expect(readAddress(`#${addressOf(address)}`)).toEqual(address);
});

it('says the robot and the rules of a contest in seconds', () => {
  const address = { mouse: 'certify', seed: 1, robot: 'mm2021', rules: 'all-japan' };
  expect(addressOf(address)).toBe('live&mouse=certify&seed=1&robot=mm2021&rules=all-japan');
  expect(readAddress(addressOf(address))).toEqual(address);
});

it('leaves out what is not said', () => {
  expect(addressOf({})).toBe('live');
  expect(readAddress('#live')).toEqual({});
  expect(readAddress('live&mouse=')).toEqual({});
});

it('keeps odd texts whole', () => {
  const mouse = 'a&b=#c %41 ä<b>';
  expect(readAddress(`#${addressOf({ mouse })}`)).toEqual({ mouse });
});

it('is of Live alone', () => {
  expect(readAddress('')).toBeNull();
  expect(readAddress('#draw')).toBeNull();
  expect(readAddress('#maze=abc')).toBeNull();
  expect(readAddress('#lively&seed=1')).toBeNull();
});

it('takes what is cut or mistyped for what it can', () => {
  expect(readAddress('#live&mouse=a%4&seed=-1&budget=1e3')).toEqual({ mouse: 'a%4' });
  expect(readAddress('#live&seed=99999999999999999&&=3&x')).toEqual({});
  expect(readAddress('#live&seed=9007199254740992')).toEqual({});
  expect(readAddress('#live&seed=0')).toEqual({ seed: 0 });
});
