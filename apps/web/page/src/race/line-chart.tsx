// A line for each mouse over a number, with its name at its end.
import { useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { usePainted } from '../ui/painted';
import { paperWidth, tone } from '../ui/tones';
import { nameLines, roomForNames } from './line-names';
import { styleOf } from './mouse-styles';

export interface Lines {
  xs: number[];
  /** In percent; `mouse` decides what a line looks like. */
  lines: { mouse: number; name: string; values: (number | null)[] }[];
  /** The labels of both axes; what else there is of the horizontal one, by its width. */
  labels: [x: string, y: string];
  axis?: (width: number) => uPlot.Axis;
  scale: uPlot.Scale;
  cursor: uPlot.Cursor;
  series: uPlot.Series;
  /** Hears where the pointer is. */
  pointed?: (plot: uPlot) => void;
}

function optionsOf({ xs: _, lines, labels, axis, scale, cursor, series, pointed }: Lines, room: number): uPlot.Options {
  const font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
  const thin = { stroke: tone('line'), width: 1 };
  const common = { stroke: tone('muted'), grid: thin, ticks: thin, font, labelFont: font, labelSize: 20 };
  const names = lines.map(({ name }) => name);
  const styles = lines.map(({ mouse }) => styleOf(mouse));
  const beside = roomForNames(names, room);
  const tones = styles.map((style) => style.tone);
  return {
    padding: [8, beside, 0, 0],
    width: Math.max(240, room),
    height: room < 500 ? 260 : 320,
    legend: { show: false },
    cursor,
    scales: { x: { time: false, ...scale }, y: { range: () => [0, 100] } },
    axes: [
      { ...common, size: 32, label: labels[0], ...axis?.(room - beside) },
      { ...common, size: 44, label: labels[1] },
    ],
    series: [
      {},
      ...styles.map(({ tone: colour, dash }, i) => ({
        label: names[i],
        stroke: tone(colour),
        dash,
        width: 2,
        ...series,
      })),
    ],
    hooks: { setCursor: pointed ? [pointed] : [], draw: [(self) => nameLines(self, names, tones, beside)] },
  };
}

interface Props {
  /** What it shows, for those who do not see it. */
  label: string;
  lines(): Lines;
  /** Where these are others, it is drawn anew. */
  of: unknown[];
}

export function LineChart({ label, lines, of }: Props) {
  const room = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  usePainted(
    room,
    () => {
      plot.current?.destroy();
      plot.current = null;
      const { clientWidth } = room.current!;
      if (clientWidth === 0) return;
      const drawn = lines();
      const options = optionsOf(drawn, paperWidth() ?? clientWidth);
      plot.current = new uPlot(options, [drawn.xs, ...drawn.lines.map(({ values }) => values)], room.current!);
    },
    of,
  );
  return <div class="curves" role="img" aria-label={label} ref={room} />;
}
