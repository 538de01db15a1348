// Means with their intervals along one axis: a head with the ticks, and a picture for each row.
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
  const Grid = ({ from, to }: { from: number; to: number }) => (
    <>
      {marks.map((mark) => (
        <line class="grid" x1={at(mark)} x2={at(mark)} y1={from} y2={to} />
      ))}
    </>
  );
  const box = (height: number) => ({ class: 'whisker', width, height, viewBox: `0 0 ${width} ${height}` });

  return {
    head: () => (
      <svg {...box(headHeight)} aria-hidden="true">
        <Grid from={headHeight - 4} to={headHeight} />
        {marks.map((mark) => (
          <text x={at(mark)} y={headHeight - 6} text-anchor="middle">
            {number(mark, digits)}
          </text>
        ))}
      </svg>
    ),
    row(mean: unknown, interval: unknown) {
      const middle = rowHeight / 2;
      const ends = isInterval(interval) ? interval.map(at) : [];
      const label = isInterval(interval) ? `${number(interval[0], 3)} to ${number(interval[1], 3)}` : 'no interval';
      return (
        <svg {...box(rowHeight)} role="img" aria-label={label}>
          <title>{label}</title>
          <Grid from={0} to={rowHeight} />
          {ends.length > 0 && <line class="bar" x1={ends[0]} x2={ends[1]} y1={middle} y2={middle} />}
          {ends.map((x) => (
            <line class="bar" x1={x} x2={x} y1={middle - 4} y2={middle + 4} />
          ))}
          {isNumber(mean) && <circle class="mean" cx={at(mean)} cy={middle} r={3.5} />}
        </svg>
      );
    },
  };
}
