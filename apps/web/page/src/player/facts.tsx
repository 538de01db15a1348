// The numbers of the moment and of the whole contest; of two contests beside each other, with their differences.
import { Meanings } from '../ui/meanings';
import { optimumMeaning } from '../ui/terms';
import { accelerationText, durationText, speedText } from './drive';
import { isComparable, type PanelProps, type Side } from './state';
import { counted, decimal, percent, short } from './figures';
import { scoreAt } from './track';
import { poseText, readingText, runText } from './words';

interface Row {
  label: string;
  meaning?: (side: Side) => string;
  /** A number, to be subtracted; `text` says it. Null where it does not apply. */
  value?: (side: Side) => number | null;
  text: (side: Side, value: number | null) => string;
  /** A score, which has as many decimals as the world says wherever it stands. */
  score?: boolean;
  /** Whether it says anything of such a contest; of all where that is missing. */
  has?: (side: Side) => boolean;
}

const absent = '–';
const orAbsent = (write: (value: number) => string) => (_: Side, value: number | null) =>
  value === null ? absent : write(value);
const digits = ({ track }: Side) => track.play.traits.digits;
const hasRuns = ({ track }: Side) => track.play.traits.runs.length > 1;

type Played = Side['track']['play'];

/** A score of a contest, with its unit if it has one. */
const scoreRow = (label: string, value: Row['value'], meaning?: Row['meaning']): Row => ({
  label,
  meaning,
  value,
  text: (side, score) =>
    score === null ? absent : [decimal(score, digits(side)), side.track.play.traits.unit].filter(Boolean).join(' '),
  score: true,
});
const countOf = (label: string, value: (play: Played) => number | null, more: Partial<Row> = {}): Row => ({
  label,
  value: ({ track }) => value(track.play),
  text: orAbsent((v) => counted(v, 'step')),
  ...more,
});
const shareOf = (label: string, value: (play: Played) => number | null): Row =>
  countOf(label, value, { text: orAbsent(percent), has: ({ track }) => value(track.play) !== null });

const outcome: Row = { label: 'outcome', text: ({ track }) => track.play.outcome };
const score = scoreRow('score', ({ track }) => track.play.score);
const best = scoreRow(
  'best possible',
  ({ track }) => track.play.bound,
  ({ track }) => track.play.traits.bound,
);
const visited = shareOf('cells visited', ({ visited: share }) => share);

/** `3 + 17/30`: what the score of that moment is made of. */
function madeOf(side: Side): string {
  const { track, scene } = side;
  const { frame } = scene.past;
  const factor = track.play.rules?.search_factor;
  return factor ? `${track.speed[frame]} + ${track.search[frame]} / ${factor}` : '';
}

const now: Row[] = [
  { label: 'run', text: runText },
  {
    label: 'steps',
    value: (side) => side.scene.past.frame,
    text: (side, frame) => `${frame} of ${side.track.last}`,
  },
  { label: 'mouse at', text: poseText },
  { label: 'left, ahead, right', text: readingText, has: ({ track }) => track.play.left.length > 0 },
  {
    label: 'speed + search',
    meaning: () => 'what the score is made of: steps of the speed run, and a share of those of the search run',
    text: madeOf,
    has: ({ track }) => track.play.rules !== null,
  },
  scoreRow('score so far', ({ track, scene }) => scoreAt(track, scene.past.frame)),
  {
    label: 'time',
    value: (side) => side.track.time[side.scene.past.frame],
    text: (side, time) => `${decimal(time!, 1)} of ${decimal(side.track.time[side.track.last], 1)} s`,
    has: ({ track }) => track.play.traits.clock === 'seconds',
  },
];

const whole: Row[] = [
  outcome,
  score,
  best,
  countOf('search', (play) => play.search_steps, { has: hasRuns }),
  countOf('speed run', (play) => play.speed_steps, { has: hasRuns }),
  countOf('shortest run', (play) => play.optimum, { meaning: () => optimumMeaning }),
  {
    label: 'first lost step',
    meaning: () => 'the first that falls behind a shortest way to the goal; N goes there',
    text: ({ track }) => (track.lossFrame < 0 ? absent : String(track.lossFrame + 1)),
    has: ({ track }) => track.play.loses.length > 0,
  },
  shareOf('cells discovered', (play) => play.discovered),
  visited,
];

function countRows(sides: Side[]): Row[] {
  const names = new Set(sides.flatMap(({ track }) => track.play.counts.map(({ name }) => name)));
  const value = (name: string) => (side: Side) =>
    side.track.play.counts.find((count) => count.name === name)?.value ?? null;
  for (const { label } of whole) names.delete(label);
  return [...names].map((name) => ({ label: name, value: value(name), text: orAbsent(String) }));
}

/** Rows of a contest in seconds: of its moment, of its present run, of the whole. */
const driven: Row[] = [
  { label: 'run', text: runText },
  {
    label: 'time in the maze',
    value: ({ scene }) => scene.moment?.time ?? null,
    text: (side, time) => `${decimal(time ?? 0)} of ${decimal(side.track.time[side.track.last])} s`,
  },
  { label: 'time in this run', text: (side) => durationText(inRun(side)) },
  { label: 'since the gate', text: (side) => durationText(sinceGate(side)) },
  { label: 'mouse at', text: poseText },
  {
    label: 'speed',
    value: ({ scene }) => scene.moment?.v ?? null,
    text: orAbsent(speedText),
  },
  { label: 'acceleration', text: ({ scene }) => accelerationText(scene.moment?.a ?? 0) },
  scoreRow('best so far', (side) => numberOr(side.track.score[side.scene.past.frame])),
  outcome,
  score,
  best,
  scoreRow(
    'fastest, from rest',
    ({ track }) => track.play.optimum,
    () => 'the fastest run for who knows the maze, from rest at the start to the middle of a goal',
  ),
  { label: 'robot', text: ({ track }) => track.play.drive?.robot.name ?? absent },
  {
    label: 'rules',
    meaning: ({ track }) => track.play.drive?.rules.source ?? '',
    text: ({ track }) => track.play.drive?.rules.name ?? absent,
  },
  {
    label: 'decisions',
    value: ({ track }) => track.play.drive?.decisions ?? null,
    text: (side, v) => `${v ?? 0}, ${side.track.play.drive?.replanned ?? 0} replanned`,
  },
  visited,
];

const numberOr = (value: number) => (Number.isNaN(value) ? null : value);

/** Microseconds since the present run began, and since it last left the start cell, which ends in the goal. */
function inRun({ track, scene: { moment } }: Side): number | null {
  const run = track.drive?.runs[moment?.run ?? -1];
  return run && moment ? moment.time * 1e6 - run.begin : null;
}
function sinceGate({ track, scene: { moment } }: Side): number | null {
  const run = track.drive?.runs[moment?.run ?? -1];
  if (!run || !moment || run.gate_out === null || moment.time * 1e6 < run.gate_out) return null;
  const now = Math.min(moment.time * 1e6, run.gate_in ?? Infinity);
  return now - Math.max(run.gate_out, ...(run.laps ?? []).filter((lap) => lap <= now));
}

function rowsOf(sides: Side[]): Row[] {
  if (sides.every(({ track }) => track.drive)) return driven;
  return [...now, ...whole, ...countRows(sides)].filter(({ has }) => !has || sides.some(has));
}

function amountOf(row: Row, by: number, side: Side): string {
  if (row.label.startsWith('cells ')) return `${(100 * by).toFixed(1)} points`;
  return row.score ? decimal(by, digits(side)) : short(by);
}

/** The first less the second, as in Race, with a sign. */
function difference(row: Row, [first, second]: Side[]): string {
  const a = row.value?.(first) ?? null;
  const b = row.value?.(second) ?? null;
  if (a === null || b === null) return '';
  const text = amountOf(row, Math.abs(a - b), first);
  return Number.parseFloat(text) === 0 ? '0' : (a > b ? '+' : '−') + text;
}

export function Facts({ state: { sides } }: PanelProps) {
  const rows = rowsOf(sides);
  const compared = isComparable(sides);
  const names = sides.map(({ name }) => name);
  const checked = sides.map(({ track }) => track.play.checked).filter((words) => words !== '');
  return (
    <section class="facts">
      <h3>Numbers</h3>
      <div class="wide" tabIndex={0} role="region" aria-label="Numbers">
        <table>
          <thead>
            <tr>
              <td />
              {[...names, ...(compared ? [names.join(' − ')] : [])].map((name) => (
                <th scope="col" title={name}>
                  {name}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <tr key={row.label}>
                <th scope="row" title={row.meaning?.(sides[0])}>
                  {row.label}
                </th>
                {sides.map((side) => (
                  <td>{row.text(side, row.value?.(side) ?? null)}</td>
                ))}
                {compared && <td>{difference(row, sides)}</td>}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <Meanings of={rows.map(({ label, meaning }) => [label, meaning?.(sides[0])])} />
      {checked.map((words) => (
        <p class="note">{words}</p>
      ))}
    </section>
  );
}
