// The distributions: for each mouse, how many of its contests stay within a ratio to the bound.
import { useMemo, useRef, useState } from 'preact/hooks';
import uPlot from 'uplot';
import { Check } from '../ui/controls';
import { usePainted } from '../ui/painted';
import { tone } from '../ui/tones';
import type { Board } from '../results/contests';
import { grid, ratiosOf, shares } from './curves-data';
import { number } from '../ui/format';
import { Scrolling, Table } from '../ui/table';
import { LineChart, type Lines } from './line-chart';
import { styleOf } from './mouse-styles';

const shownAtFirst = 6;
const marks = [1, 1.1, 1.25, 1.5, 2, 3, 5, 10, 20, 50, 100];
/** Beside the axis, and for a label on it, in pixels. */
const [axisRoom, labelRoom] = [70, 32];
const stepped = uPlot.paths.stepped!({ align: 1 });
const limits = [1.001, 1.05, 1.1, 1.25, 1.5, 2, 3];

/** Those up to `end` whose labels do not touch on a logarithmic axis of that room. */
function marksApart(end: number, room: number): number[] {
  const place = (mark: number) => (Math.log(mark) / Math.log(end)) * (room - axisRoom);
  const kept: number[] = [];
  for (const mark of marks)
    if (mark <= end && (kept.length === 0 || place(mark) - place(kept[kept.length - 1]) >= labelRoom)) kept.push(mark);
  return kept;
}

/** A piece of a mouse's curve, for the legend. */
function Sample({ mouse }: { mouse: number }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const paint = () => {
    const context = canvas.current!.getContext('2d');
    const style = styleOf(mouse);
    if (!context) return;
    context.clearRect(0, 0, 56, 6);
    context.strokeStyle = tone(style.tone);
    context.lineWidth = 4;
    context.setLineDash(style.dash.map((length) => length * 2));
    context.beginPath();
    context.moveTo(0, 3);
    context.lineTo(56, 3);
    context.stroke();
  };
  usePainted(canvas, paint, [mouse]);
  return <canvas class="sample" width={56} height={6} aria-hidden="true" ref={canvas} />;
}

type Data = ReturnType<typeof ratiosOf>[];

/** The same as a table, for eyes that do not see curves, and for paper. */
function AsTable({ board, data }: { board: Board; data: Data }) {
  const heads = ['mouse', ...limits.map((limit, i) => (i === 0 ? '1' : `≤ ${limit}`))];
  const rows = board.mice.map(({ name, index }) => [
    name,
    ...shares(data[index], limits).map((share) => number(share, 1)),
  ]);
  return (
    <details class="controls">
      <summary>As a table</summary>
      <Scrolling label="Distributions as a table">
        <Table heads={heads} rows={rows} caption="Percentage of all contests with at most that score / best." />
      </Scrolling>
    </details>
  );
}

/** What the pointer is at: a ratio, and the value of each mouse there. */
interface Pointed {
  ratio: number;
  values: Map<number, number | null | undefined>;
}

function linesOf(board: Board, data: Data, mice: number[], log: boolean, point: (at: Pointed | null) => void): Lines {
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
    pointed({ cursor: { idx }, data }) {
      const values = (place: number) => new Map(mice.map((mouse, series) => [mouse, data[series + 1][place]]));
      point(idx === null || idx === undefined ? null : { ratio: data[0][idx], values: values(idx) });
    },
  };
}

/** The mice are a legend in which one chooses; it also says what the pointer is at. */
export function Distributions({ board }: { board: Board }) {
  const data = useMemo(() => board.mice.map(({ index }) => ratiosOf(board, index)), [board]);
  const [chosen, choose] = useState(() => board.mice.slice(0, shownAtFirst).map(({ index }) => index));
  const [isLogarithmic, setLogarithmic] = useState(true);
  const [at, point] = useState<Pointed | null>(null);
  function set(mouse: number, isOn: boolean) {
    choose(board.mice.map(({ index }) => index).filter((one) => (one === mouse ? isOn : chosen.includes(one))));
    point(null);
  }
  const valueAt = (mouse: number) => {
    const value = at?.values.get(mouse);
    return value === null || value === undefined ? '' : `${number(value, 1)} %`;
  };
  return (
    <div>
      <LineChart
        label="Percentage of contests within a score / best, for each mouse. The table below has the same numbers."
        lines={() => linesOf(board, data, chosen, isLogarithmic, point)}
        of={[board, chosen, isLogarithmic]}
      />
      <fieldset class="pick">
        <legend>
          Mice <span>{at && `within ${number(at.ratio, 3)}:`}</span>
        </legend>
        {board.mice.map(({ name, index }) => (
          <label title={name} class={chosen.includes(index) ? '' : 'off'}>
            <input
              type="checkbox"
              checked={chosen.includes(index)}
              onChange={({ currentTarget }) => set(index, currentTarget.checked)}
            />
            <span>
              <Sample mouse={index} />
            </span>
            <span class="name">{name}</span>
            <output>{valueAt(index)}</output>
          </label>
        ))}
      </fieldset>
      <Check label="logarithmic" class="row controls" checked={isLogarithmic} change={setLogarithmic} />
      <AsTable board={board} data={data} />
    </div>
  );
}
