import { expect, it } from 'vitest';
import type { Core } from '../../src/core/client';
import { fetchBeliefs } from '../../src/player/beliefs';
import { prepare } from '../../src/player/track';
import { steps } from './plays';

const coreWith = (bytes: number[]) => {
  const asked: unknown[] = [];
  const call = (name: string, request: unknown) => (
    asked.push([name, request]),
    Promise.resolve({ bytes: Uint8Array.from(bytes) })
  );
  return { core: { call } as unknown as Core, asked };
};

it('asks for all frames, with the knowledge and the stride of the play', async () => {
  const { core, asked } = coreWith([]);
  const track = prepare(steps());
  await fetchBeliefs(core, track);
  expect(asked).toEqual([['beliefs', { maze: track.maze, known: track.play.known, frames: 9, stride: 3 }]]);
});

it('reads numbers of two bytes, the lower one first, for each cell of each frame', async () => {
  const { core } = coreWith([3, 0, 1, 1, 255, 255]);
  const beliefs = await fetchBeliefs(core, prepare(steps()));
  expect([...beliefs.subarray(0, 4)]).toEqual([3, 257, 65535, 0]);
  expect(beliefs).toHaveLength(9 * 6);
});

it('does not ask for more than the page should hold', async () => {
  const { core, asked } = coreWith([]);
  const track = prepare(steps());
  await expect(fetchBeliefs(core, { ...track, last: 12_000_000 })).rejects.toThrow('12000001 frames are too many');
  expect(asked).toEqual([]);
});
