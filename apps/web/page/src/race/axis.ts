// Round numbers along an axis.

/** About `count` round numbers that cover low to high; the first is at or below low, the last at or above high. */
export function ticks(low: number, high: number, count: number): number[] {
  if (!(high > low)) high = low + 1;
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough * 0.999)!;
  const first = Math.floor(low / step + 1e-9);
  const last = Math.ceil(high / step - 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step);
}

/** As many digits as those ticks need. */
export function tickDigits(values: number[]): number {
  const step = values.length > 1 ? values[1] - values[0] : 1;
  return Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)));
}
