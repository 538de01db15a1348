// Means with their intervals along one axis: a head with the ticks, and a picture for each row.
import { svg } from '../ui/dom';
import { tickDigits, ticks } from './axis';
import { isNumber, number } from '../ui/format';

const width = 210;
const margin = 14;
const rowHeight = 22;
const headHeight = 18;

const isInterval = (value: unknown): value is [number, number] =>
  Array.isArray(value) && value.length === 2 && value.every(isNumber);

/** For rows with those means and intervals. */
export function whiskers(rows: { mean: unknown; interval: unknown }[]) {
  const values = rows.flatMap(({ mean, interval }) => [
    ...(isNumber(mean) ? [mean] : []),
    ...(isInterval(interval) ? interval : []),
  ]);
  const marks = values.length > 0 ? ticks(Math.min(...values), Math.max(...values), 4) : [0, 1];
  const [low, high] = [marks[0], marks[marks.length - 1]];
  const digits = tickDigits(marks);
  const at = (value: number) => Math.round((margin + ((value - low) / (high - low)) * (width - 2 * margin)) * 10) / 10;
  const grid = (from: number, to: number) =>
    marks.map((mark) => svg('line', { class: 'grid', x1: at(mark), x2: at(mark), y1: from, y2: to }));

  return {
    head: () =>
      svg(
        'svg',
        { class: 'whisker', width, height: headHeight, viewBox: `0 0 ${width} ${headHeight}`, 'aria-hidden': 'true' },
        ...grid(headHeight - 4, headHeight),
        ...marks.map((mark) =>
          svg('text', { x: at(mark), y: headHeight - 6, 'text-anchor': 'middle' }, number(mark, digits)),
        ),
      ),
    row(mean: unknown, interval: unknown) {
      const middle = rowHeight / 2;
      const parts: SVGElement[] = [];
      if (isInterval(interval)) {
        const [from, to] = interval.map(at);
        parts.push(svg('line', { class: 'bar', x1: from, x2: to, y1: middle, y2: middle }));
        for (const x of [from, to])
          parts.push(svg('line', { class: 'bar', x1: x, x2: x, y1: middle - 4, y2: middle + 4 }));
      }
      if (isNumber(mean)) parts.push(svg('circle', { class: 'mean', cx: at(mean), cy: middle, r: 3.5 }));
      const label = isInterval(interval) ? `${number(interval[0], 3)} to ${number(interval[1], 3)}` : 'no interval';
      return svg(
        'svg',
        {
          class: 'whisker',
          width,
          height: rowHeight,
          viewBox: `0 0 ${width} ${rowHeight}`,
          role: 'img',
          'aria-label': label,
        },
        svg('title', {}, label),
        ...grid(0, rowHeight),
        ...parts,
      );
    },
  };
}
