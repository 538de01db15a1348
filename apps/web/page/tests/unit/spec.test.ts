import { expect, it } from 'vitest';
import type { Mouse, Parameter } from '../../src/core/types';
import { readSpec, specOf, valueOf } from '../../src/choice/spec';

const parameter = (name: string, usual: string): Parameter => ({ name, type: 'choice', default: usual, meaning: '' });
const mice: Mouse[] = [
  { name: 'flood', summary: '', is_stochastic: false, parameters: [] },
  {
    name: 'phases',
    summary: '',
    is_stochastic: true,
    parameters: [parameter('searching', 'goal'), parameter('weights', '2/5/2')],
  },
];

it('leaves out defaults and keeps the order of the table', () => {
  expect(specOf('phases', {}, mice)).toBe('phases');
  expect(specOf('phases', { weights: '2/5/2' }, mice)).toBe('phases');
  const values = { weights: '1/5/2', searching: 'random' };
  expect(specOf('phases', values, mice)).toBe('phases:searching=random:weights=1/5/2');
});

it('keeps what it does not know, so that the core can say what is wrong with it', () => {
  expect(specOf('phases', { serching: 'random' }, mice)).toBe('phases:serching=random');
  expect(specOf('nobody', { a: '1' }, mice)).toBe('nobody:a=1');
});

it('reads what it wrote', () => {
  const values = { searching: 'random', weights: '1/5/2' };
  expect(readSpec(specOf('phases', values, mice))).toEqual({ mouse: 'phases', values });
  expect(readSpec(' flood ')).toEqual({ mouse: 'flood', values: {} });
  expect(readSpec('flood:home')).toEqual({ mouse: 'flood', values: { home: null } });
  expect(readSpec('a:b=c=d')).toEqual({ mouse: 'a', values: { b: 'c=d' } });
});

it('leaves a setting without = as it was written', () => {
  for (const spec of ['flood:home', 'flood:home=', 'flood:', 'flood:=a', 'phases:weights'])
    expect(specOf(readSpec(spec).mouse, readSpec(spec).values, mice)).toBe(spec);
});

it('has a value for each parameter', () => {
  expect(valueOf(parameter('a', 'yes'), {})).toBe('yes');
  expect(valueOf(parameter('a', 'yes'), { a: '' })).toBe('');
});
