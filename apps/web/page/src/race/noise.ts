// The share of contests that each mouse finishes as noise grows, and what ended the others.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../ui/dom';
import { paperWidth, tone } from '../ui/tones';
import { number } from '../ui/format';
import { nameLines, roomForNames } from './line-names';
import { styleOf } from './mouse-styles';
import type { NoiseCurves } from './noise-data';

function table({ noises, mice }: NoiseCurves, title: string, cell: (mouse: number, noise: number) => string) {
  return h(
    'div',
    { class: 'box', tabindex: 0, role: 'region', 'aria-label': title },
    h(
      'table',
      {},
      h('caption', {}, title),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, 'mouse'),
          ...noises.map((noise) => h('th', { scope: 'col' }, `noise ${noise}`)),
        ),
      ),
      h(
        'tbody',
        {},
        ...mice.map(({ name }, mouse) =>
          h('tr', {}, h('th', { scope: 'row' }, name), ...noises.map((_, noise) => h('td', {}, cell(mouse, noise)))),
        ),
      ),
    ),
  );
}

export function noisePicture(curves: NoiseCurves): { element: HTMLElement; arrange(): void } {
  const { noises, mice } = curves;
  let plot: uPlot | null = null;
  const picture = h('div', {
    class: 'curves',
    role: 'img',
    'aria-label': 'Percentage of contests that each mouse finished, by noise. The table below has the same numbers.',
  });
  const room = () => (picture.clientWidth > 0 ? (paperWidth() ?? picture.clientWidth) : 0);

  function options(): uPlot.Options {
    const axis = {
      stroke: tone('muted'),
      grid: { stroke: tone('line'), width: 1 },
      ticks: { stroke: tone('line'), width: 1 },
    };
    const font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
    const names = mice.map(({ name }) => name);
    const tones = mice.map((_, mouse) => styleOf(mouse).tone);
    const beside = roomForNames(names, room());
    return {
      padding: [8, beside, 0, 0],
      width: Math.max(240, room()),
      height: room() < 500 ? 260 : 320,
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [noises[0], noises[noises.length - 1]] },
        y: { range: () => [0, 100] },
      },
      axes: [
        { ...axis, font, labelFont: font, labelSize: 20, size: 32, label: 'noise', splits: () => noises },
        { ...axis, font, labelFont: font, labelSize: 20, size: 44, label: 'contests finished, %' },
      ],
      series: [
        {},
        ...mice.map(({ name }, mouse) => ({
          label: name,
          stroke: tone(styleOf(mouse).tone),
          dash: styleOf(mouse).dash,
          width: 2,
          points: { show: true, size: 5 },
        })),
      ],
      hooks: { draw: [(self) => nameLines(self, names, tones, beside)] },
    };
  }
  function arrange() {
    plot?.destroy();
    plot = null;
    if (room() === 0) return;
    plot = new uPlot(options(), [noises, ...mice.map(({ finished }) => finished)], picture);
  }
  const endings = (mouse: number, noise: number) =>
    [...mice[mouse].ended[noise]]
      .sort(([a, many], [b, more]) => more - many || a.localeCompare(b))
      .map(([end, times]) => `${end} ${times}`)
      .join(', ') || '–';
  const element = h(
    'div',
    {},
    picture,
    table(curves, 'Contests finished, %', (mouse, noise) => number(mice[mouse].finished[noise], 1)),
    h(
      'details',
      { class: 'controls' },
      h('summary', {}, 'What ended the others'),
      table(curves, 'Contests without a score, by what ended them', endings),
    ),
  );
  return { element, arrange };
}
