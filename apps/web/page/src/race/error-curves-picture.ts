// The share of contests that each mouse finishes as noise or variation grows, and what ended the others.
import { h } from '../ui/dom';
import { number } from '../ui/format';
import { scrolling, table } from '../ui/table';
import { createLineChart } from './line-chart';
import type { ErrorCurves } from './error-curves';

function curveTable(
  { scaled, scales, mice }: ErrorCurves,
  title: string,
  cell: (mouse: number, scale: number) => string,
) {
  const heads = ['mouse', ...scales.map((scale) => `${scaled} ${scale}`)];
  const rows = mice.map(({ name }, mouse) => [name, ...scales.map((_, scale) => cell(mouse, scale))]);
  return scrolling(title, table({}, heads, rows, title));
}

export function errorCurvesPicture(curves: ErrorCurves): { element: HTMLElement; arrange(): void } {
  const { scaled, scales, mice } = curves;
  const chart = createLineChart(
    `Percentage of contests that each mouse finished, by ${scaled}. The table below has the same numbers.`,
  );
  const arrange = () =>
    chart.draw(() => ({
      xs: scales,
      lines: mice.map(({ name, finished }, mouse) => ({ mouse, name, values: finished })),
      labels: [scaled, 'contests finished, %'],
      axis: () => ({ splits: () => scales }),
      scale: { range: () => [scales[0], scales[scales.length - 1]] },
      cursor: { show: false },
      series: { points: { show: true, size: 5 } },
    }));
  const endings = (mouse: number, scale: number) =>
    [...mice[mouse].ended[scale]]
      .sort(([a, many], [b, more]) => more - many || a.localeCompare(b))
      .map(([end, times]) => `${end} ${times}`)
      .join(', ') || '–';
  const element = h(
    'div',
    chart.element,
    curveTable(curves, 'Contests finished, %', (mouse, scale) => number(mice[mouse].finished[scale], 1)),
    h(
      'details.controls',
      h('summary', 'What ended the others'),
      curveTable(curves, 'Contests without a score, by what ended them', endings),
    ),
  );
  return { element, arrange };
}
