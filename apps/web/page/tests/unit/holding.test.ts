// A race in the page under several noises.
import { expect, it } from 'vitest';
import type { Core } from '../../src/core/client';
import type { Fields, WorldInPage } from '../../src/core/types';
import { eachOf, holdRace } from '../../src/results/holding';
import { errorCurves } from '../../src/race/error-curves';

const setting = (name: string, more = {}) => ({ name, type: 'text', default: '1', meaning: '', ...more });
const worlds = [
  { name: 'physical', settings: [setting('robot'), setting('noise', { listed: true })] },
] as unknown as WorldInPage[];

/** A core that writes down which races it is asked for. */
function coreOf(asked: Fields[]): Core {
  const call = async (name: string, request: Fields) => {
    if (name === 'about') return { worlds };
    asked.push(request);
    const { mice, noise } = request as { mice: string[]; noise: string };
    const group = { world: 'physical', noise: Number(noise), mazes: [], mice: [{ name: mice[0], results: [] }] };
    return { results: { labmouse: '1', stopped: false, groups: [group] } };
  };
  return { call } as unknown as Core;
}
const order = (noise: string) => ({
  ...{ mice: ['flood', 'certify'], mazes: [], runs: 1, seed: 1 },
  world: { world: 'physical', noise, robot: 'a,b' },
});

it('is held once for each noise, with all mice in each', async () => {
  const asked: Fields[] = [];
  const held = await holdRace(
    coreOf(asked),
    order('0, 1,2'),
    () => undefined,
    () => true,
  );
  expect(asked.map(({ mice, noise }) => [mice, noise])).toEqual(
    ['flood', 'certify'].flatMap((mouse) => ['0', '1', '2'].map((noise) => [[mouse], noise])),
  );
  const { groups } = held!.results;
  expect(groups.map(({ noise, mice }) => [noise, mice.map(({ name }) => name)])).toEqual(
    [0, 1, 2].map((noise) => [noise, ['flood', 'certify']]),
  );
  expect(errorCurves(groups)!.scales).toEqual([0, 1, 2]);
});

it('of one noise is held once for each mouse', async () => {
  const asked: Fields[] = [];
  await holdRace(
    coreOf(asked),
    order('1'),
    () => undefined,
    () => true,
  );
  expect(asked).toHaveLength(2);
});

it('that is stopped between two noises has no mouse with one of them alone', async () => {
  const asked: Fields[] = [];
  const held = await holdRace(
    coreOf(asked),
    order('0,1'),
    () => undefined,
    () => asked.length < 3,
  );
  expect(held!.results.groups.map(({ mice }) => mice.map(({ name }) => name))).toEqual([['flood'], ['flood']]);
  expect(held!.results.stopped).toBe(true);
});

it('takes commas of no other setting as those of a list', () => {
  expect(eachOf(order('1').world, worlds)).toEqual([order('1').world]);
});
