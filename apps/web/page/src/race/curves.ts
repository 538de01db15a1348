// The distributions: for each mouse, how many of its contests stay within a ratio to the bound.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../ui/dom';
import { paperWidth, tone } from '../ui/tones';
import type { Board } from '../results/contests';
import { grid, ratiosOf, shares } from './curves-data';
import { number } from '../ui/format';
import { nameLines, roomForNames } from './line-names';
import { styleOf } from './mouse-styles';

const shownAtFirst = 6;
const marks = [1, 1.1, 1.25, 1.5, 2, 3, 5, 10, 20, 50, 100];
/** Beside the axis, and for a label on it, in pixels. */
const [axisRoom, labelRoom] = [70, 32];
const stepped = uPlot.paths.stepped!({ align: 1 });
const limits = [1.001, 1.05, 1.1, 1.25, 1.5, 2, 3];

export interface Curves {
  element: HTMLElement;
  arrange(): void;
}

/** Those up to `end` whose labels do not touch on a logarithmic axis of that room. */
function marksApart(end: number, room: number): number[] {
  const place = (mark: number) => (Math.log(mark) / Math.log(end)) * (room - axisRoom);
  const kept: number[] = [];
  for (const mark of marks)
    if (mark <= end && (kept.length === 0 || place(mark) - place(kept[kept.length - 1]) >= labelRoom)) kept.push(mark);
  return kept;
}

/** A piece of a mouse's curve, for the legend. */
function sample(mouse: number): HTMLCanvasElement {
  const canvas = h('canvas', { class: 'sample', width: 56, height: 6, 'aria-hidden': 'true' });
  const context = canvas.getContext('2d');
  const style = styleOf(mouse);
  if (!context) return canvas;
  context.strokeStyle = tone(style.tone);
  context.lineWidth = 4;
  context.setLineDash(style.dash.map((length) => length * 2));
  context.moveTo(0, 3);
  context.lineTo(56, 3);
  context.stroke();
  return canvas;
}

/** The same as a table, for eyes that do not see curves, and for paper. */
function asTable(board: Board, data: ReturnType<typeof ratiosOf>[], best: string) {
  const head = limits.map((limit, i) => h('th', { scope: 'col' }, i === 0 ? '1' : `≤ ${limit}`));
  const rows = board.mice.map(({ name, index }) =>
    h(
      'tr',
      {},
      h('th', { scope: 'row' }, name),
      ...shares(data[index], limits).map((share) => h('td', {}, number(share, 1))),
    ),
  );
  return h(
    'details',
    { class: 'controls' },
    h('summary', {}, 'As a table'),
    h(
      'div',
      { class: 'box', tabindex: 0, role: 'region', 'aria-label': 'Distributions as a table' },
      h(
        'table',
        {},
        h('caption', {}, `Percentage of all contests with at most that score / ${best}.`),
        h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'mouse'), ...head)),
        h('tbody', {}, ...rows),
      ),
    ),
  );
}

export function curves(board: Board): Curves {
  const { best } = board.shows;
  const data = board.mice.map(({ index }) => ratiosOf(board, index));
  const chosen = new Set(board.mice.slice(0, shownAtFirst).map(({ index }) => index));
  let log = true;
  let plot: uPlot | null = null;

  const picture = h('div', {
    class: 'curves',
    role: 'img',
    'aria-label': `Percentage of contests within a score / ${best}, for each mouse. The table below has the same numbers.`,
  });
  const at = h('span', {});
  const values = board.mice.map(() => h('output', {}));
  const samples = board.mice.map(() => h('span', {}));
  const labels = board.mice.map(({ name, index }) => {
    const box = h('input', {
      type: 'checkbox',
      checked: chosen.has(index),
      onchange: () => choose(index, box.checked),
    });
    return h(
      'label',
      { class: chosen.has(index) ? '' : 'off', title: name },
      box,
      samples[index],
      h('span', { class: 'name' }, name),
      values[index],
    );
  });
  const logBox = h('input', { type: 'checkbox', checked: true, onchange: () => ((log = logBox.checked), arrange()) });

  function choose(mouse: number, on: boolean) {
    if (on) chosen.add(mouse);
    else chosen.delete(mouse);
    labels[mouse].className = on ? '' : 'off';
    arrange();
  }
  function read(self: uPlot) {
    const place = self.cursor.idx;
    at.textContent = place === null || place === undefined ? '' : `within ${number(self.data[0][place], 3)}:`;
    [...chosen]
      .sort((a, b) => a - b)
      .forEach((mouse, series) => {
        const value = place === null || place === undefined ? null : self.data[series + 1][place];
        values[mouse].textContent = value === null || value === undefined ? '' : `${number(value, 1)} %`;
      });
  }
  const room = () => (picture.clientWidth > 0 ? (paperWidth() ?? picture.clientWidth) : 0);
  function options(mice: number[], end: number): uPlot.Options {
    const axis = {
      stroke: tone('muted'),
      grid: { stroke: tone('line'), width: 1 },
      ticks: { stroke: tone('line'), width: 1 },
    };
    const font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
    const names = mice.map((mouse) => board.mice[mouse].name);
    const tones = mice.map((mouse) => styleOf(mouse).tone);
    const beside = roomForNames(names, room());
    const splits = marksApart(end, room() - beside);
    return {
      padding: [8, beside, 0, 0],
      width: Math.max(240, room()),
      height: room() < 500 ? 260 : 320,
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { size: 7 } },
      scales: { x: { time: false, distr: log ? 3 : 1, range: () => [1, end] }, y: { range: () => [0, 100] } },
      axes: [
        {
          ...axis,
          font,
          labelFont: font,
          labelSize: 20,
          size: 32,
          label: `score / ${best}${log ? ' (logarithmic)' : ''}`,
          ...(log && { splits: () => splits, filter: (_: uPlot, all: number[]) => all }),
          values: (_, all) => all.map((value) => (value === null ? '' : String(Math.round(value * 100) / 100))),
        },
        { ...axis, font, labelFont: font, label: 'contests within it, %', labelSize: 20, size: 44 },
      ],
      series: [
        {},
        ...mice.map((mouse) => ({
          label: board.mice[mouse].name,
          stroke: tone(styleOf(mouse).tone),
          dash: styleOf(mouse).dash,
          width: 2,
          paths: stepped,
          points: { show: false },
        })),
      ],
      hooks: { setCursor: [read], draw: [(self) => nameLines(self, names, tones, beside)] },
    };
  }
  function arrange() {
    plot?.destroy();
    plot = null;
    board.mice.forEach(({ index }) => samples[index].replaceChildren(sample(index)));
    values.forEach((value) => (value.textContent = ''));
    at.textContent = '';
    if (room() === 0) return;
    const mice = [...chosen].sort((a, b) => a - b);
    const xs = grid(Math.max(1, ...mice.map((mouse) => data[mouse].ratios.at(-1) ?? 1)), log);
    plot = new uPlot(options(mice, xs[xs.length - 1]), [xs, ...mice.map((mouse) => shares(data[mouse], xs))], picture);
  }
  const element = h(
    'div',
    {},
    picture,
    h('fieldset', { class: 'pick' }, h('legend', {}, 'Mice ', at), ...labels),
    h('label', { class: 'row controls' }, logBox, 'logarithmic'),
    asTable(board, data, best),
  );
  return { element, arrange };
}
