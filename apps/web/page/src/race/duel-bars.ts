// The differences of two mice as sorted bars: below zero the first is better.
import type { PairedDifference } from '../core/types';
import { tone } from '../ui/tones';
import { tickDigits, ticks } from './axis';
import type { Pair } from './duel-data';
import { signed } from '../ui/format';

const left = 52;
const height = 240;
const edge = 10;

export interface Bars {
  /** The pair below that point of the canvas; null beside all. */
  at(x: number): Pair | null;
}

/** Paints on a canvas of that width; pairs are sorted by their difference. */
export function paintBars(
  canvas: HTMLCanvasElement,
  pairs: Pair[],
  found: PairedDifference | null,
  width: number,
): Bars {
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const step = (width - left) / Math.max(1, pairs.length);
  const context = canvas.getContext('2d');
  if (context && pairs.length > 0) {
    context.scale(ratio, ratio);
    paint(context, pairs, found, width, step);
  }
  return { at: (x) => pairs[Math.floor((x - left) / step)] ?? null };
}

function paint(
  context: CanvasRenderingContext2D,
  pairs: Pair[],
  found: PairedDifference | null,
  width: number,
  step: number,
) {
  const values = pairs.map(({ difference }) => difference);
  const marks = ticks(Math.min(0, ...values), Math.max(0, ...values), 6);
  const [low, high] = [marks[0], marks[marks.length - 1]];
  const digits = tickDigits(marks);
  const y = (value: number) => edge + ((high - value) / (high - low)) * (height - 2 * edge);

  context.font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const mark of marks) {
    context.fillStyle = tone(Math.abs(mark) < 1e-9 ? 'muted' : 'line');
    context.fillRect(left, Math.round(y(mark)), width - left, 1);
    context.fillStyle = tone('muted');
    context.fillText(signed(mark, digits), left - 6, y(mark));
  }
  const wide = Math.max(0.5, step - (step > 4 ? 1 : 0));
  pairs.forEach(({ difference }, place) => {
    const x = left + place * step;
    context.fillStyle = tone(difference < 0 ? 'to-goal' : difference > 0 ? 'route' : 'faint');
    if (difference === 0) context.fillRect(x, y(0) - 2, wide, 4);
    else context.fillRect(x, Math.min(y(0), y(difference)), wide, Math.max(1, Math.abs(y(difference) - y(0))));
  });
  if (found) paintMean(context, found, width, y);
}

/** The mean as a line over a band, its interval. */
function paintMean(
  context: CanvasRenderingContext2D,
  { mean, interval: [low, high], count }: PairedDifference,
  width: number,
  y: (value: number) => number,
) {
  context.fillStyle = tone('ink');
  if (count > 1) {
    context.globalAlpha = 0.15;
    context.fillRect(left, y(high), width - left, Math.max(1, y(low) - y(high)));
    context.globalAlpha = 1;
  }
  context.fillRect(left, Math.round(y(mean)) - 0.75, width - left, 1.5);
}
