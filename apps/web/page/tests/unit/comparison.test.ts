import { expect, it } from 'vitest';
import type { Play } from '../../src/core/types';
import { comparisonInWords, type Walk } from '../../src/live/comparison';
import { isSameMaze } from '../../src/maze/same';

const walk = (spec: string, score: number | null, action: string[], more: Partial<Walk> = {}): Walk => ({
  spec,
  seed: 1,
  budget: 1000,
  record: '',
  play: {
    score,
    action,
    maze: { name: spec, width: 1, height: 1, walls: [15], start: [0, 0], goals: [[0, 0]] },
  } as unknown as Play,
  ...more,
});

it('says what changed and what came of it', () => {
  const before = walk('flood', 20, ['ahead']);
  expect(comparisonInWords(before, walk('certify', 18.5, ['left']))).toBe(
    'flood → certify: score 20.000 → 18.500 (−1.500; lower is better)',
  );
  expect(comparisonInWords(before, walk('flood', 21, ['left'], { seed: 2, budget: 500 }))).toBe(
    'seed 1 → 2, budget 1000 → 500: score 20.000 → 21.000 (+1.000; lower is better)',
  );
  expect(comparisonInWords(before, walk('flood:stride=1', null, ['left']))).toBe(
    'flood → flood:stride=1: score 20.000 → no score',
  );
  expect(comparisonInWords(before, walk('oracle', 20, ['ahead']))).toBe('flood → oracle: the same walk, score 20.000');
  expect(comparisonInWords(before, walk('oracle', 20, ['left']))).toContain('(±0;');
});

it('compares walks of one maze only, whatever its name', () => {
  const { play: one } = walk('a', 1, []);
  const { play: other } = walk('b', 1, []);
  expect(isSameMaze(one, other)).toBe(true);
  other.maze.start = [1, 0];
  expect(isSameMaze(one, other)).toBe(false);
});
