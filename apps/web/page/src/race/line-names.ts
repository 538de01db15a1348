// The names of lines, where they end, each beside its line and none on another.
import type uPlot from 'uplot';
import { fitting } from '../ui/fitting';
import { tone } from '../ui/tones';

const lineHeight = 13;

/** Room for the longest of such names, in pixels, of a picture that wide. */
export const roomForNames = (names: string[], width: number) =>
  Math.min(7 * Math.max(0, ...names.map((name) => name.length)) + 18, width / 3);

/** Places for labels that want to be at those heights: in their order, not closer than a line, between top and bottom. */
export function spread(wanted: number[], top: number, bottom: number, line = lineHeight): number[] {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b] || a - b);
  const placed = new Array<number>(wanted.length);
  let least = top;
  for (const i of order) least = (placed[i] = Math.max(wanted[i], least)) + line;
  let most = bottom;
  for (const i of [...order].reverse()) most = (placed[i] = Math.min(placed[i], most)) - line;
  return placed;
}

/** A hook of uPlot: writes the names of its series beside its right end, with a line to where each is meant. */
export function nameLines(plot: uPlot, names: string[], tones: string[], room: number) {
  const { ctx: context, bbox } = plot;
  const ratio = devicePixelRatio || 1;
  const right = bbox.left + bbox.width;
  const ends = names.map((_, i) =>
    plot.valToPos([...plot.data[i + 1]].reverse().find((v) => v != null) ?? 0, 'y', true),
  );
  const places = spread(ends, bbox.top, bbox.top + bbox.height, lineHeight * ratio);
  context.save();
  context.font = `${11 * ratio}px ${getComputedStyle(document.documentElement).fontFamily}`;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.lineWidth = ratio;
  context.setLineDash([]);
  names.forEach((name, i) => {
    context.strokeStyle = tone(tones[i]);
    context.beginPath();
    context.moveTo(right, ends[i]);
    context.lineTo(right + 10 * ratio, places[i]);
    context.stroke();
    context.fillStyle = tone('ink');
    context.fillText(fitting(context, name, (room - 14) * ratio), right + 13 * ratio, places[i]);
  });
  context.restore();
}
