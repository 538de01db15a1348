// How mice fare as noise grows: of races that differ in nothing but their noise.
import type { Fields, RaceGroup } from '../core/types';
import { isNumber } from '../ui/format';

export interface NoisyMouse {
  name: string;
  /** Percent of its contests with a score, under each noise; null where it did not race. */
  finished: (number | null)[];
  /** How often each end that is no score came, under each noise. */
  ended: Map<string, number>[];
}

export interface NoiseCurves {
  noises: number[];
  mice: NoisyMouse[];
}

function endingsOf(results: Fields[]): Map<string, number> {
  const ended = new Map<string, number>();
  for (const { score, ended_by } of results)
    if (!isNumber(score) && typeof ended_by === 'string') ended.set(ended_by, (ended.get(ended_by) ?? 0) + 1);
  return ended;
}

function finishedOf(results: Fields[]): number | null {
  if (results.length === 0) return null;
  return (100 * results.filter(({ score }) => isNumber(score)).length) / results.length;
}

/** The mice in the order of the quietest race; null where there are no two noises. */
export function noiseCurves(groups: RaceGroup[]): NoiseCurves | null {
  const noisy = groups
    .flatMap(({ noise, mice }) => (isNumber(noise) ? [{ noise, mice }] : []))
    .sort((a, b) => a.noise - b.noise);
  const noises = noisy.map(({ noise }) => noise);
  if (noises.length < 2 || new Set(noises).size < noises.length) return null;
  const mice = noisy[0].mice.map(({ name }) => {
    const results = noisy.map((race) => race.mice.find((mouse) => mouse.name === name)?.results ?? []);
    return { name, finished: results.map(finishedOf), ended: results.map(endingsOf) };
  });
  return { noises, mice };
}
