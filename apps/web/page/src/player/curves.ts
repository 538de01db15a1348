// Speed and acceleration of the present run over its time, below the maze.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../ui/dom';
import { onTones, paperWidth, tone } from '../ui/tones';
import { accelerationText, clockText, kinds, speedText, type DriveTrack, type Moment } from './drive';
import type { Actions, Side, State } from './state';

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

export function createCurves(state: State, actions: Actions) {
  const picture = h('div.speeds', { role: 'img' });
  const label = 'Speed and acceleration';
  const title = h('h3', label);
  const text = h('p.reading');
  const mark = h('div.now');
  const element = h('section.drive-curves', { hidden: true, 'aria-label': label }, title, text, picture);
  let plot: uPlot | null = null;
  let side: Side | null = null;
  let [run, place] = [-1, NaN];
  const drive = () => side?.track.drive;
  const begin = () => (drive()?.runs[run]?.begin ?? 0) / 1e6;

  function draw() {
    plot?.destroy();
    plot = null;
    const width = paperWidth() ?? picture.clientWidth;
    const track = drive();
    if (!track || run < 0 || width === 0) return;
    const data = curveData(track, run);
    if (data[0].length < 2) return;
    const name = `${side!.name}, run ${run + 1}: ${kinds[track.runs[run].kind]}`;
    title.textContent = `Speed and acceleration: ${name}`;
    picture.setAttribute('aria-label', inWords(name, data));
    plot = new uPlot(optionsOf(width, data, tick), data, picture);
    plot.over.append(mark);
    plot.over.addEventListener('click', ({ offsetX }) => actions.seek(begin() + plot!.posToVal(offsetX, 'x')));
    place = NaN;
  }
  function tick() {
    const moment = side?.scene.moment;
    if (!moment || !plot) return;
    const at = Math.round(plot.valToPos(moment.time - begin(), 'x') * 2) / 2;
    if (at === place) return;
    place = at;
    mark.style.transform = `translateX(${Math.min(Math.max(at, 0), plot.over.clientWidth)}px)`;
  }
  new ResizeObserver(() => element.hidden || draw()).observe(picture);
  onTones(() => element.hidden || draw());
  return {
    element,
    /** Moves the mark of the present moment; in every frame of the browser. */
    tick,
    /** After the frame has changed, some times a second while it plays. */
    update() {
      const chosen = state.sides[state.chosen];
      const { moment } = chosen.scene;
      element.hidden = !chosen.track.drive || !moment || moment.run < 0;
      if (element.hidden) return void (side = null);
      if (chosen !== side || moment!.run !== run) {
        side = chosen;
        run = moment!.run;
        draw();
      }
      tick();
      const words = readingOf(moment!, begin());
      if (text.textContent !== words) text.textContent = words;
    },
  };
}
