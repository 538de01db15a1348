// The letters of start and goal, on a canvas that only notes them.
import { expect, it } from 'vitest';
import { fit } from '../../src/maze/geometry';
import { paintMaze, type Context } from '../../src/maze/painter';
import type { Palette } from '../../src/maze/palette';
import { steps } from './plays';

function lettersOf(corner: boolean) {
  const maze = steps().maze;
  const geometry = fit(maze, 400, 400, 1, { left: 0, bottom: 0 });
  const letters: { text: string; share: number }[] = [];
  const fillText = (text: string, x: number) => {
    if (!/[SG]/.test(text)) return;
    letters.push({ text, share: ((x - geometry.left) % geometry.pitch) / geometry.pitch });
  };
  paintMaze({ fillText, fillRect: () => undefined } as unknown as Context, geometry, {} as Palette, maze, corner);
  return { maze, letters };
}

it('the start and each goal have a letter, in the middle of their cells or in a corner', () => {
  for (const corner of [false, true]) {
    const { maze, letters } = lettersOf(corner);
    expect(letters.map(({ text }) => text).join('')).toBe(`S${'G'.repeat(maze.goals.length)}`);
    for (const { share } of letters) expect(share).toBeCloseTo(corner ? 0.25 : 0.5, 1);
  }
});
