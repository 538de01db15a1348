// The share of contests that each mouse finishes as noise grows, and what ended the others.
import { h } from '../ui/dom';
import { number } from '../ui/format';
import { scrolling, table } from '../ui/table';
import { createLineChart } from './line-chart';
import type { NoiseCurves } from './noise-data';

function noiseTable({ noises, mice }: NoiseCurves, title: string, cell: (mouse: number, noise: number) => string) {
  const heads = ['mouse', ...noises.map((noise) => `noise ${noise}`)];
  const rows = mice.map(({ name }, mouse) => [name, ...noises.map((_, noise) => cell(mouse, noise))]);
  return scrolling(title, table({}, heads, rows, title));
}

export function noisePicture(curves: NoiseCurves): { element: HTMLElement; arrange(): void } {
  const { noises, mice } = curves;
  const chart = createLineChart(
    'Percentage of contests that each mouse finished, by noise. The table below has the same numbers.',
  );
  const arrange = () =>
    chart.draw(() => ({
      xs: noises,
      lines: mice.map(({ name, finished }, mouse) => ({ mouse, name, values: finished })),
      labels: ['noise', 'contests finished, %'],
      axis: () => ({ splits: () => noises }),
      scale: { range: () => [noises[0], noises[noises.length - 1]] },
      cursor: { show: false },
      series: { points: { show: true, size: 5 } },
    }));
  const endings = (mouse: number, noise: number) =>
    [...mice[mouse].ended[noise]]
      .sort(([a, many], [b, more]) => more - many || a.localeCompare(b))
      .map(([end, times]) => `${end} ${times}`)
      .join(', ') || '–';
  const element = h(
    'div',
    chart.element,
    noiseTable(curves, 'Contests finished, %', (mouse, noise) => number(mice[mouse].finished[noise], 1)),
    h(
      'details.controls',
      h('summary', 'What ended the others'),
      noiseTable(curves, 'Contests without a score, by what ended them', endings),
    ),
  );
  return { element, arrange };
}
