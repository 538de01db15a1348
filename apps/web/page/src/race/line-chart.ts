// A line for each mouse over a number, with its name at its end.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../ui/dom';
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

/** `label` says what it shows, to those who do not see it. */
export function createLineChart(label: string) {
  const element = h('div.curves', { role: 'img', 'aria-label': label });
  let plot: uPlot | null = null;
  return {
    element,
    /** Draws anew, where there is room. */
    draw(lines: () => Lines) {
      plot?.destroy();
      plot = null;
      if (element.clientWidth === 0) return;
      const drawn = lines();
      const options = optionsOf(drawn, paperWidth() ?? element.clientWidth);
      plot = new uPlot(options, [drawn.xs, ...drawn.lines.map(({ values }) => values)], element);
    },
  };
}
