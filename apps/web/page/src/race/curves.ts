// The distributions: for each mouse, how many of its contests stay within a ratio to the bound.
import uPlot from 'uplot';
import { h } from '../ui/dom';
import { tone } from '../ui/tones';
import type { Board } from '../results/contests';
import { grid, ratiosOf, shares } from './curves-data';
import { number } from '../ui/format';
import { scrolling, table } from '../ui/table';
import { createLineChart, type Lines } from './line-chart';
import { styleOf } from './mouse-styles';

const shownAtFirst = 6;
const marks = [1, 1.1, 1.25, 1.5, 2, 3, 5, 10, 20, 50, 100];
/** Beside the axis, and for a label on it, in pixels. */
const [axisRoom, labelRoom] = [70, 32];
const stepped = uPlot.paths.stepped!({ align: 1 });
const limits = [1.001, 1.05, 1.1, 1.25, 1.5, 2, 3];

export type Curves = ReturnType<typeof curves>;

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
  const canvas = h('canvas.sample', { width: 56, height: 6, 'aria-hidden': 'true' });
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
function asTable(board: Board, data: ReturnType<typeof ratiosOf>[]) {
  const heads = ['mouse', ...limits.map((limit, i) => (i === 0 ? '1' : `≤ ${limit}`))];
  const rows = board.mice.map(({ name, index }) => [
    name,
    ...shares(data[index], limits).map((share) => number(share, 1)),
  ]);
  const caption = 'Percentage of all contests with at most that score / best.';
  return h(
    'details.controls',
    h('summary', 'As a table'),
    scrolling('Distributions as a table', table({}, heads, rows, caption)),
  );
}

/** The mice as a legend in which one chooses; it also says what the pointer is at. */
function createPick(board: Board, changed: () => void) {
  const chosen = new Set(board.mice.slice(0, shownAtFirst).map(({ index }) => index));
  const at = h('span');
  const entries = board.mice.map(({ name, index }) => {
    const [line, value] = [h('span'), h('output')];
    const box = h('input', { type: 'checkbox', checked: chosen.has(index), onchange: () => choose() });
    const label = h('label', { title: name }, box, line, h('span.name', name), value);
    function choose() {
      if (box.checked) chosen.add(index);
      else chosen.delete(index);
      label.className = box.checked ? '' : 'off';
      changed();
    }
    label.className = box.checked ? '' : 'off';
    return { label, line, value };
  });
  const mice = () => [...chosen].sort((a, b) => a - b);
  return {
    element: h('fieldset.pick', h('legend', 'Mice ', at), ...entries.map(({ label }) => label)),
    mice,
    clear() {
      entries.forEach(({ line, value }, index) => {
        line.replaceChildren(sample(index));
        value.textContent = '';
      });
      at.textContent = '';
    },
    read({ cursor, data }: uPlot) {
      const place = cursor.idx ?? null;
      at.textContent = place === null ? '' : `within ${number(data[0][place], 3)}:`;
      mice().forEach((mouse, series) => {
        const value = place === null ? null : data[series + 1][place];
        entries[mouse].value.textContent = value === null || value === undefined ? '' : `${number(value, 1)} %`;
      });
    },
  };
}

export function curves(board: Board) {
  const data = board.mice.map(({ index }) => ratiosOf(board, index));
  const chart = createLineChart(
    'Percentage of contests within a score / best, for each mouse. The table below has the same numbers.',
  );
  const pick = createPick(board, arrange);
  const logarithmic = h('input', { type: 'checkbox', checked: true, onchange: arrange });

  function lines(): Lines {
    const log = logarithmic.checked;
    const mice = pick.mice();
    const xs = grid(Math.max(1, ...mice.map((mouse) => data[mouse].ratios.at(-1) ?? 1)), log);
    const end = xs[xs.length - 1];
    return {
      xs,
      lines: mice.map((mouse) => ({ mouse, name: board.mice[mouse].name, values: shares(data[mouse], xs) })),
      labels: [`score / best${log ? ' (logarithmic)' : ''}`, 'contests within it, %'],
      axis: (width) => ({
        ...(log && { splits: () => marksApart(end, width), filter: (_: uPlot, all: number[]) => all }),
        values: (_, all) => all.map((value) => (value === null ? '' : String(Math.round(value * 100) / 100))),
      }),
      scale: { distr: log ? 3 : 1, range: () => [1, end] },
      cursor: { y: false, drag: { x: false, y: false }, points: { size: 7 } },
      series: { paths: stepped, points: { show: false } },
      pointed: pick.read,
    };
  }
  function arrange() {
    pick.clear();
    chart.draw(lines);
  }
  const element = h(
    'div',
    chart.element,
    pick.element,
    h('label.row.controls', logarithmic, 'logarithmic'),
    asTable(board, data),
  );
  return { element, arrange };
}
