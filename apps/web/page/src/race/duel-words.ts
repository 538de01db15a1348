// What the differences of two mice show, in a sentence.
import type { PairedDifference } from '../core/types';
import { counted, number, signed } from './format';

/** As the command line judges: by the interval. */
export function verdictOf({ interval: [low, high] }: PairedDifference): 'better' | 'worse' | 'no difference shown' {
  return high < 0 ? 'better' : low > 0 ? 'worse' : 'no difference shown';
}

const chance = (p: number) => (p < 0.0001 ? 'p < 0.0001' : `p = ${number(p, 4)}`);

export function duelWords(a: string, b: string, found: PairedDifference, unit: string): string {
  const { count, mean, interval, below, equal, above, sign_test } = found;
  const range = count < 2 ? '' : ` (95 % interval ${signed(interval[0], 3)} to ${signed(interval[1], 3)})`;
  const verdict = count < 2 ? '' : `: ${verdictOf(found)}`;
  return (
    `${a} against ${b}: ${signed(mean, 3)} ${unit} on average${range} over ${counted(count, 'maze')}${verdict}. ` +
    `Lower in ${below}, equal in ${equal}, higher in ${above}; sign test ${chance(sign_test)}.`
  );
}
