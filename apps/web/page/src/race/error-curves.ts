// How many contests mice finish as noise or variation grows: of races that differ in nothing else.
import type { Fields, RaceGroup } from '../core/types';
import { isNumber } from '../ui/format';

export interface CurveMouse {
  name: string;
  /** Percent of its contests with a score, at each scale; null where it did not race. */
  finished: (number | null)[];
  /** How often each end that is no score came, at each scale. */
  ended: Map<string, number>[];
}

export interface ErrorCurves {
  /** What is scaled. */
  scaled: 'noise' | 'variation';
  scales: number[];
  mice: CurveMouse[];
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

/** The mice in the order of the race with the smallest scale; null where the races do not differ in just one scale. */
export function errorCurves(groups: RaceGroup[]): ErrorCurves | null {
  const all = (['noise', 'variation'] as const).filter((key) => new Set(groups.map((group) => group[key])).size > 1);
  if (all.length !== 1) return null;
  const [scaled] = all;
  const races = groups
    .flatMap(({ [scaled]: scale, mice }) => (isNumber(scale) ? [{ scale, mice }] : []))
    .sort((a, b) => a.scale - b.scale);
  const scales = races.map(({ scale }) => scale);
  if (scales.length < 2 || new Set(scales).size < scales.length) return null;
  const mice = races[0].mice.map(({ name }) => {
    const results = races.map((race) => race.mice.find((mouse) => mouse.name === name)?.results ?? []);
    return { name, finished: results.map(finishedOf), ended: results.map(endingsOf) };
  });
  return { scaled, scales, mice };
}
