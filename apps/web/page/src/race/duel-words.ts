// What the differences of two mice show, in a sentence.
import type { PairedDifference } from '../core/types';
import { counted, number, signed } from '../ui/format';

const chance = (p: number) => (p < 0.0001 ? 'p < 0.0001' : `p = ${number(p, 4)}`);

export function duelWords(a: string, b: string, found: PairedDifference, unit: string): string {
  const { count, mean, interval, below, equal, above, sign_test } = found;
  const range = count < 2 ? '' : ` (95 % interval ${signed(interval[0], 3)} to ${signed(interval[1], 3)})`;
  return (
    `${a} against ${b}: ${signed(mean, 3)} ${unit} on average${range} over ${counted(count, 'maze')}: ${verdictWords(found)}. ` +
    `Lower in ${below}, equal in ${equal}, higher in ${above}; sign test ${chance(sign_test)}.`
  );
}

const verdictWords = ({ verdict, count }: PairedDifference) =>
  verdict === 'too few mazes' ? `no verdict, which needs 8 mazes (add ${8 - count})` : verdict;

/** Where failed contests have no score: `failed` is about their shares in the mazes. */
export function failureWords(failed: PairedDifference, limit: number, unit: string): string {
  const { mean, interval, count } = failed;
  const range =
    count < 2 ? '' : ` (95 % interval ${signed(-100 * interval[1], 1)} to ${signed(-100 * interval[0], 1)})`;
  return (
    ` Failed contests count ${limit} ${unit}. The first finished ${signed(-100 * mean, 1)} of 100 contests more` +
    `${range}: ${verdictWords(failed)}.`
  );
}
