// Who is ahead, and by how much: before a goal in cells, then in the seconds of the best run so far.

import { counted } from '../ui/format';

export interface Standing {
  name: string;
  /** Seconds of the best run so far; NaN before the first. */
  best: number;
  /** Cells that are left to the goal, as they truly are. */
  left: number;
}

/** In a few words: "flood is 3 cells nearer to the goal". */
export function gapInWords(one: Standing, other: Standing): string {
  const [runs, others] = [!Number.isNaN(one.best), !Number.isNaN(other.best)];
  if (runs && others) {
    const by = Math.abs(one.best - other.best);
    return by < 0.0005
      ? `equal best runs, ${one.best.toFixed(3)} s`
      : `${(one.best < other.best ? one : other).name} leads by ${by.toFixed(3)} s`;
  }
  if (runs || others) return `${(runs ? one : other).name} was at the goal first`;
  const by = Math.abs(one.left - other.left);
  return by === 0
    ? 'side by side'
    : `${(one.left < other.left ? one : other).name} is ${counted(by, 'cell')} nearer to the goal`;
}
