// Speed and acceleration of the present run over its time, below the maze.
import { useLayoutEffect, useMemo } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { onTones, paperWidth, tone } from '../ui/tones';
import { accelerationText, clockText, kinds, speedText, type DriveTrack, type Moment } from './drive';
import type { Actions, Side, State } from './state';
import type { Track } from './track';

const stepped = uPlot.paths.stepped!({ align: 1 });
const height = 190;

export type Curves = ReturnType<typeof createCurves>;

/** Seconds since the run began, m/s, m/s². */
export function curveData({ path, runs }: DriveTrack, run: number): [number[], number[], number[]] {
  const { from, to, begin } = runs[run];
  const cut = (list: Float64Array) => Array.from(list.subarray(from, to));
  return [cut(path.t).map((time) => time - begin / 1e6), cut(path.v), cut(path.a)];
}

/** A little more than the values need, with 0 inside. */
function rangeOf(values: number[]): [number, number] {
  const low = values.reduce((a, b) => Math.min(a, b), 0);
  const high = values.reduce((a, b) => Math.max(a, b), 0);
  const room = Math.max((high - low) * 0.06, 0.05);
  return [low < 0 ? low - room : 0, high + room];
}

/** Two scales over one time; `ready` is called once there are scales to place the mark by. */
function optionsOf(width: number, data: number[][], ready: () => void): uPlot.Options {
  const font = `12px ${getComputedStyle(document.documentElement).fontFamily}`;
  const axis = { font, labelFont: font, labelSize: 18, ticks: { stroke: tone('line'), width: 1 } };
  const grid = { stroke: tone('line'), width: 1 };
  const speed = rangeOf(data[1]);
  const acceleration = rangeOf(data[2]);
  return {
    width,
    height,
    legend: { show: false },
    cursor: { show: false },
    scales: {
      x: { time: false, range: () => [0, Math.max(data[0][data[0].length - 1], 0.001)] },
      y: { range: () => speed },
      a: { range: () => acceleration },
    },
    axes: [
      { ...axis, stroke: tone('muted'), grid, label: 'seconds in this run', size: 30 },
      { ...axis, stroke: tone('to-goal'), grid, label: 'm/s', size: 42 },
      { ...axis, stroke: tone('route'), grid: { show: false }, scale: 'a', side: 1, label: 'm/s²', size: 46 },
    ],
    hooks: { ready: [ready] },
    series: [
      {},
      { label: 'speed', stroke: tone('to-goal'), width: 2, points: { show: false } },
      {
        label: 'acceleration',
        scale: 'a',
        stroke: tone('route'),
        width: 1.5,
        dash: [4, 2],
        paths: stepped,
        points: { show: false },
      },
    ],
  };
}

function inWords(name: string, [times, speeds]: number[][]): string {
  const most = speeds.reduce((a, b) => Math.max(a, b), 0);
  return `Speed and acceleration over the ${clockText(times.at(-1)!)} s of ${name}; at most ${speedText(most)}.`;
}

const readingOf = ({ time, v, a }: Moment, begin: number) =>
  `${clockText(time - begin)} s: ${speedText(v)}, ${accelerationText(a)}`;

/** The run of the chosen contest that is driven now; null where none is. */
function runNow({ sides, chosen }: State): { side: Side; run: number; moment: Moment } | null {
  const side = sides[chosen];
  const moment = side?.scene.moment;
  return side?.track.drive && moment && moment.run >= 0 ? { side, run: moment.run, moment } : null;
}

const beginOf = ({ drive }: Track, run: number) => drive!.runs[run].begin / 1e6;

/** The picture, drawn anew for each run, and the mark in it. */
export function createCurves(state: State, actions: Actions) {
  let picture: HTMLElement | null = null;
  let plot: uPlot | null = null;
  let drawn: { side: Side; run: number } | null = null;
  let place = NaN;

  function draw() {
    plot?.destroy();
    plot = null;
    drawn = runNow(state);
    const width = paperWidth() ?? picture?.clientWidth;
    if (!drawn || !picture || !width) return;
    const { side, run } = drawn;
    const data = curveData(side.track.drive!, run);
    if (data[0].length < 2) return;
    plot = new uPlot(optionsOf(width, data, tick), data, picture);
    plot.over.append(Object.assign(document.createElement('div'), { className: 'now' }));
    const timeAt = (x: number) => beginOf(side.track, run) + plot!.posToVal(x, 'x');
    plot.over.addEventListener('click', ({ offsetX }) => actions.seek(timeAt(offsetX)));
    place = NaN;
  }
  /** Moves the mark of the present moment; in every frame of the browser. */
  function tick() {
    const moment = drawn?.side.scene.moment;
    if (!moment || !plot || !drawn) return;
    const at = Math.round(plot.valToPos(moment.time - beginOf(drawn.side.track, drawn.run), 'x') * 2) / 2;
    if (at === place) return;
    place = at;
    const mark = plot.over.querySelector<HTMLElement>('.now')!;
    mark.style.transform = `translateX(${Math.min(Math.max(at, 0), plot.over.clientWidth)}px)`;
  }
  const observer = new ResizeObserver(draw);
  onTones(draw);
  return {
    tick,
    enter(room: HTMLElement | null) {
      observer.disconnect();
      picture = room;
      if (room) observer.observe(room);
    },
    /** After the frame has changed, some times a second while it plays. */
    update() {
      const now = runNow(state);
      if (now?.side !== drawn?.side || now?.run !== drawn?.run) draw();
      tick();
    },
  };
}

export function DriveCurves({ state, curves }: { state: State; curves: Curves }) {
  useLayoutEffect(curves.update);
  const now = runNow(state);
  const name = now && `${now.side.name}, run ${now.run + 1}: ${kinds[now.side.track.drive!.runs[now.run].kind]}`;
  const data = useMemo(() => now && curveData(now.side.track.drive!, now.run), [now?.side, now?.run]);
  return (
    <section class="drive-curves" hidden={!now} aria-label="Speed and acceleration">
      <h3>Speed and acceleration{name && `: ${name}`}</h3>
      <p class="reading">{now && readingOf(now.moment, beginOf(now.side.track, now.run))}</p>
      <div
        class="speeds"
        role="img"
        aria-label={data?.[0].length ? inWords(name!, data) : undefined}
        ref={curves.enter}
      />
    </section>
  );
}
