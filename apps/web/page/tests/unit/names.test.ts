import { expect, it } from 'vitest';
import type { MazeData } from '../../src/core/types';
import { namesOf } from '../../src/player/words';

const play = (mouse: string, maze: string) => ({ mouse, maze: { name: maze } as MazeData });

it('tells two plays apart by mouse, by maze, or by their place', () => {
  expect(namesOf([play('flood', 'a')])).toEqual(['flood']);
  expect(namesOf([play('flood', 'a'), play('certify', 'a')])).toEqual(['flood', 'certify']);
  expect(namesOf([play('flood', 'a'), play('flood', 'b')])).toEqual(['flood, a', 'flood, b']);
  expect(namesOf([play('flood', 'a'), play('flood', 'a')])).toEqual(['flood, 1', 'flood, 2']);
});
