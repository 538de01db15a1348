// How many contests stay within a ratio to the bound: one rising curve for each mouse.
import type { Board } from '../results/contests';

const samples = 480;
/** Beyond this, a curve says no more than that it ends there. */
const farthest = 100;

/** The ratios of a mouse's finished contests, ascending, and how many contests there were in mazes with a route. */
export function ratiosOf({ cells, mazes }: Board, mouse: number): { ratios: number[]; contests: number } {
  const counted = cells[mouse].filter((_, maze) => mazes[maze].bound !== null).flatMap(({ contests }) => contests);
  const ratios = counted.flatMap(({ ratio }) => (ratio === null ? [] : [ratio]));
  return { ratios: ratios.sort((a, b) => a - b), contests: counted.length };
}

/** Ratios from 1 to beyond the highest, evenly or by equal factors. */
export function grid(highest: number, log: boolean): number[] {
  const end = Math.min(farthest, Math.max(1.2, highest * 1.02));
  return Array.from({ length: samples + 1 }, (_, i) => (log ? end ** (i / samples) : 1 + ((end - 1) * i) / samples));
}

/** Percent of all contests with at most that ratio, for each one of the ascending `limits`. */
export function shares(
  { ratios, contests }: { ratios: number[]; contests: number },
  limits: number[],
): (number | null)[] {
  if (contests === 0) return limits.map(() => null);
  let within = 0;
  return limits.map((limit) => {
    while (within < ratios.length && ratios[within] <= limit + 1e-9) ++within;
    return (100 * within) / contests;
  });
}
