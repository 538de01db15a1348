// A contest in seconds: where its mouse is at any moment, how fast, and in which run.
import type { Drive, DrivePath, DriveRun } from '../core/types';
import { counted } from '../ui/format';
import { decimal, short } from './figures';

/** A path in seconds, cells, m/s and m/s². */
export interface Course {
  t: Float64Array;
  x: Float64Array;
  y: Float64Array;
  heading: Float64Array;
  v: Float64Array;
  a: Float64Array;
}

export interface DriveTrack {
  drive: Drive;
  runs: DriveRun[];
  path: Course;
  best: Course;
  /** The highest speed, m/s, more than 0; beside another play the higher of both, so that colours mean the same. */
  fastest: number;
}

/** Made once a play and changed in place. */
export interface Moment {
  time: number;
  /** Positions of the run, and of the last point of the path at or before that time; -1 where there are none. */
  run: number;
  point: number;
  x: number;
  y: number;
  heading: number;
  v: number;
  a: number;
}

const seconds = (microseconds: number) => microseconds / 1e6;
const metres = (millimetres: number) => millimetres / 1e3;

const course = ({ t, x, y, heading, v, a }: DrivePath): Course => ({
  t: Float64Array.from(t, seconds),
  x: Float64Array.from(x),
  y: Float64Array.from(y),
  heading: Float64Array.from(heading),
  v: Float64Array.from(v, metres),
  a: Float64Array.from(a, metres),
});

const least = 0.001;

export function prepareDrive(drive: Drive): DriveTrack {
  const path = course(drive.path);
  const best = course(drive.best);
  const fastest = [path.v, best.v].reduce((most, list) => list.reduce((a, b) => Math.max(a, b), most), least);
  return { drive, runs: drive.runs, path, best, fastest };
}

export const createMoment = (): Moment => ({ time: 0, run: -1, point: -1, x: 0, y: 0, heading: 0, v: 0, a: 0 });

/** The last run that has begun by then; -1 for none. */
export function runAt({ runs }: DriveTrack, time: number): number {
  let run = runs.length - 1;
  while (run >= 0 && seconds(runs[run].begin) > time) --run;
  return run;
}

/** The last point of a run at or before that time, its first one where there is none; -1 without points. */
export function pointAt({ path }: DriveTrack, { from, to }: DriveRun, time: number): number {
  if (to <= from) return -1;
  let low = from;
  let high = to - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (path.t[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Goes to a time. Between two points the way is straight, and the speed changes evenly. */
export function goTo(track: DriveTrack, time: number, moment: Moment) {
  const { path, runs } = track;
  moment.time = time;
  moment.run = runAt(track, time);
  moment.point = moment.run < 0 ? -1 : pointAt(track, runs[moment.run], time);
  const { point: i } = moment;
  if (i < 0) return;
  const span = i + 1 < runs[moment.run].to ? path.t[i + 1] - path.t[i] : 0;
  const passed = Math.min(Math.max(time - path.t[i], 0), span);
  const way = (duration: number) => path.v[i] * duration + (path.a[i] * duration * duration) / 2;
  const whole = way(span);
  // A turn on the spot has no way, but takes time.
  const share = span <= 0 ? 0 : whole > 1e-9 ? way(passed) / whole : passed / span;
  const between = (list: Float64Array) => (share > 0 ? list[i] + (list[i + 1] - list[i]) * share : list[i]);
  moment.x = between(path.x);
  moment.y = between(path.y);
  moment.heading = between(path.heading);
  moment.a = span > 0 ? path.a[i] : 0;
  moment.v = path.v[i] + moment.a * passed;
}

export const kinds: Record<DriveRun['kind'], string> = {
  search: 'search',
  home: 'way home',
  speed: 'speed run',
  laps: 'laps',
};

/** Whether a run follows a route at full speed: a speed run, or laps. */
export const followsRoute = (run: DriveRun | undefined) => run?.kind === 'speed' || run?.kind === 'laps';

const endings: Record<string, string> = {
  'given up': 'gave up',
  slid: 'tyres slipped',
  position_lost: 'localization error',
  wall_error: 'wall detection error',
  'no route left': 'no route left',
  'out of time': 'time limit',
};

/** How a run ended: `goal`, `no route left`, `crash in (3,4): tyres slipped`; empty where nothing is recorded. */
export function endText({ kind, ended, crash, gate_in, laps }: DriveRun): string {
  if (ended === null) return '';
  const done = laps ? counted(laps.length, 'lap') : kind === 'home' ? 'start' : gate_in === null ? '–' : 'goal';
  const reached = ended === 'done' ? done : '';
  const why = ended === 'done' ? '' : (endings[ended] ?? ended);
  if (!crash) return reached || why;
  const where = `crash in (${crash.cell.join(',')})`;
  return reached && reached !== '–' ? `${reached}, then ${where}` : why ? `${where}: ${why}` : where;
}

/** `12.345` for seconds. */
export const clockText = (time: number) => decimal(time, 3);
/** `8.196 s` for microseconds, or a dash. */
export const durationText = (microseconds: number | null) =>
  microseconds === null ? '–' : `${decimal(microseconds / 1e6, 3)} s`;

/** From gate to gate, of laps the fastest one; null where it did not come so far. */
export const gateToGate = ({ gate_out, gate_in, laps, score }: DriveRun) =>
  laps ? (score?.gate_to_gate ?? null) : gate_out === null || gate_in === null ? null : gate_in - gate_out;

/** `1.25 m/s`, with the sign of mathematics. */
export const speedText = (speed: number) => `${decimal(speed, 2)} m/s`;
export const accelerationText = (a: number) => `${a < -0.005 ? '−' : ''}${decimal(Math.abs(a), 2)} m/s²`;

/** `6.532 s + a thirtieth of the 96.1 s before it`: what a run's value is made of. */
export function madeOf(run: DriveRun, { gate_to_gate, maze_time_divisor: divisor }: Drive['rules']): string {
  const { score } = run;
  if (!score) return '';
  const parts = [durationText(gate_to_gate ? score.gate_to_gate : score.rest_to_centre)];
  if (score.maze_time > 0)
    parts.push(`+ ${durationText(score.maze_time)} for ${short(run.begin / 1e6)} s / ${divisor}`);
  if (score.bonus > 0) parts.push(`− ${durationText(score.bonus)} for never being touched`);
  return parts.join(' ');
}
