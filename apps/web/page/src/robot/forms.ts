// The two ways in which a file may say how a robot turns, and how it searches: limits from which times follow, or times that
// were published.
import type { RobotKey, RobotResult, RobotValue } from '../core/types';
import type { Values } from './form';

export type Part = 'turns' | 'search';
type With = RobotKey['with'];

/** Whose keys go with limits, and whose with times. */
const ways: Record<Part, { limits: With; times: With }> = {
  turns: { limits: 'curves', times: 'turns' },
  search: { limits: 'search_speed', times: 'search_times' },
};

const hasAny = (values: Values, keys: RobotKey[], way: With) =>
  keys.some((key) => key.with === way && key.name in values);

export const hasTimes = (values: Values, keys: RobotKey[], part: Part): boolean =>
  hasAny(values, keys, ways[part].times);

/** The keys that have a meaning beside those values, as the core has it. */
export function keysBeside(values: Values, keys: RobotKey[]): string[] {
  const off = (['turns', 'search'] as const).map(
    (part) => ways[part][hasTimes(values, keys, part) ? 'limits' : 'times'],
  );
  const straight = values.diagonals === false;
  return keys.filter((key) => !off.includes(key.with) && !(key.of_diagonals && straight)).map(({ name }) => name);
}

/** Times of a robot as the keys of published ones have them: each turn at the lowest speed, which all of them share. */
function timeOf({ name, kind }: RobotKey, { turns, search }: RobotResult): RobotValue | undefined {
  const [section, key] = name.split('.');
  if (section === 'search') return search[key as keyof RobotResult['search']];
  const slowest = (turn: RobotResult['turns'][number]) => turn.speeds[turn.speeds.length - 1];
  if (key === 'speed') return Math.min(...turns.map((turn) => slowest(turn).speed));
  const turn = turns.find((one) => one.turn === key);
  return turn ? slowest(turn).ms : kind === 'number_or_false' ? false : undefined;
}

/** The same robot with the times that follow from it in the place of its limits. */
export function withTimes(values: Values, keys: RobotKey[], part: Part, result: RobotResult): Values {
  const { limits, times } = ways[part];
  const next = without(values, keys, limits);
  for (const key of keys.filter((one) => one.with === times)) {
    const time = key.of_diagonals && values.diagonals === false ? undefined : timeOf(key, result);
    if (time !== undefined) next[key.name] = time;
  }
  return next;
}

/** The same robot with the limits of another one in the place of its times. */
export function withLimits(values: Values, keys: RobotKey[], part: Part, other: Values): Values {
  const { limits, times } = ways[part];
  const next = without(values, keys, times);
  for (const { name, with: way, of_diagonals } of keys)
    if (way === limits && name in other && !(of_diagonals && values.diagonals === false)) next[name] = other[name];
  return next;
}

function without(values: Values, keys: RobotKey[], way: With): Values {
  const gone = new Set(keys.filter((key) => key.with === way).map(({ name }) => name));
  return Object.fromEntries(Object.entries(values).filter(([name]) => !gone.has(name)));
}
