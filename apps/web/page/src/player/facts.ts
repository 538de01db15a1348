// The numbers of the moment and of the whole contest; of two contests beside each other, with their differences.
import { isSameMaze } from '../maze/same';
import { h } from '../ui/dom';
import { meanings } from '../ui/meanings';
import { boundOf, optimumMeaning } from '../ui/terms';
import { accelerationText, durationText, speedText } from './drive';
import type { Panel, Side, State } from './state';
import { counted, decimal, percent, short } from './figures';
import { scoreAt } from './track';
import { poseText, readingText, runText } from './words';

interface Row {
  label: string;
  meaning?: (side: Side) => string;
  /** A number, to be subtracted; `text` says it. Null where it does not apply. */
  value?: (side: Side) => number | null;
  text: (side: Side, value: number | null) => string;
  /** Where it changes with the frame. */
  live?: boolean;
  /** A score, which has three decimals (one in mms) wherever it stands. */
  score?: boolean;
}

const absent = '–';
const orAbsent = (write: (value: number) => string) => (_: Side, value: number | null) =>
  value === null ? absent : write(value);
const isMms = (side: Side) => side.track.play.world === 'mms';
const digits = (side: Side) => (isMms(side) ? 1 : 3);

/** `3 + 17/30`: what the score of that moment is made of. */
function madeOf(side: Side): string {
  const { track, scene } = side;
  const { frame } = scene.past;
  const factor = track.play.rules?.exploration_factor;
  return factor ? `${track.speed[frame]} + ${track.exploration[frame]} / ${factor}` : '';
}

const now: Row[] = [
  { label: 'run', text: runText, live: true },
  {
    label: 'steps',
    value: (side) => side.scene.past.frame,
    text: (side, frame) => `${frame} of ${side.track.last}`,
    live: true,
  },
  { label: 'mouse at', text: poseText, live: true },
  { label: 'left, ahead, right', text: readingText, live: true },
  {
    label: 'speed + exploration',
    meaning: () => 'what the score is made of: steps of the speed run, and a share of those of the exploration',
    text: madeOf,
    live: true,
  },
  {
    label: 'score so far',
    value: ({ track, scene }) => scoreAt(track, scene.past.frame),
    text: (side, score) => (score === null ? absent : decimal(score, digits(side))),
    live: true,
    score: true,
  },
];

const seconds: Row = {
  label: 'time in mms',
  value: (side) => side.track.time[side.scene.past.frame],
  text: (side, time) => `${decimal(time!, 1)} of ${decimal(side.track.time[side.track.last], 1)} s`,
  live: true,
};

const whole: Row[] = [
  { label: 'outcome', text: ({ track }) => track.play.outcome },
  {
    label: 'score',
    value: ({ track }) => track.play.score,
    text: (side, v) => (v === null ? absent : decimal(v, digits(side))),
    score: true,
  },
  {
    label: 'best possible',
    meaning: ({ track }) => boundOf(track.play.world),
    value: ({ track }) => track.play.bound,
    text: (side, v) => (v === null ? absent : decimal(v, digits(side))),
    score: true,
  },
  {
    label: 'exploration',
    value: ({ track }) => track.play.exploration_steps,
    text: orAbsent((v) => counted(v, 'step')),
  },
  { label: 'speed run', value: ({ track }) => track.play.speed_steps, text: orAbsent((v) => counted(v, 'step')) },
  {
    label: 'shortest run',
    meaning: () => optimumMeaning,
    value: ({ track }) => track.play.optimum,
    text: orAbsent((v) => counted(v, 'step')),
  },
  { label: 'cells discovered', value: ({ track }) => track.play.discovered, text: orAbsent(percent) },
  { label: 'cells visited', value: ({ track }) => track.play.visited, text: orAbsent(percent) },
];

const ofSteps = new Set([
  'left, ahead, right',
  'speed + exploration',
  'exploration',
  'speed run',
  'cells discovered',
  'cells visited',
]);

function countRows(sides: Side[]): Row[] {
  const names = new Set(sides.flatMap(({ track }) => track.play.counts.map(({ name }) => name)));
  const value = (name: string) => (side: Side) =>
    side.track.play.counts.find((count) => count.name === name)?.value ?? null;
  for (const { label } of whole) names.delete(label);
  return [...names].map((name) => ({ label: name, value: value(name), text: orAbsent(String) }));
}

/** Rows of a contest in seconds: of its moment, of its present run, of the whole. */
const driven: Row[] = [
  { label: 'run', text: runText, live: true },
  {
    label: 'time in the maze',
    value: ({ scene }) => scene.moment?.time ?? null,
    text: (side, time) => `${decimal(time ?? 0)} of ${decimal(side.track.time[side.track.last])} s`,
    live: true,
  },
  { label: 'time in this run', text: (side) => durationText(inRun(side)), live: true },
  { label: 'since the gate', text: (side) => durationText(sinceGate(side)), live: true },
  { label: 'mouse at', text: poseText, live: true },
  {
    label: 'speed',
    value: ({ scene }) => scene.moment?.v ?? null,
    text: orAbsent(speedText),
    live: true,
  },
  { label: 'acceleration', text: ({ scene }) => accelerationText(scene.moment?.a ?? 0), live: true },
  {
    label: 'best so far',
    value: (side) => numberOr(side.track.score[side.scene.past.frame]),
    text: orAbsent((v) => `${decimal(v)} s`),
    live: true,
    score: true,
  },
  { label: 'outcome', text: ({ track }) => track.play.outcome },
  { label: 'score', value: ({ track }) => track.play.score, text: orAbsent((v) => `${decimal(v)} s`), score: true },
  {
    label: 'best possible',
    meaning: ({ track }) => boundOf(track.play.world),
    value: ({ track }) => track.play.bound,
    text: orAbsent((v) => `${decimal(v)} s`),
    score: true,
  },
  {
    label: 'fastest, from rest',
    meaning: () => 'the fastest run for who knows the maze, from rest at the start to the middle of a goal',
    value: ({ track }) => track.play.optimum,
    text: orAbsent((v) => `${decimal(v)} s`),
    score: true,
  },
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
  { label: 'cells visited', value: ({ track }) => track.play.visited, text: orAbsent(percent) },
];

const numberOr = (value: number) => (Number.isNaN(value) ? null : value);

/** Microseconds since the present run began, and since it left the start cell, which ends in the goal. */
function inRun({ track, scene: { moment } }: Side): number | null {
  const run = track.drive?.runs[moment?.run ?? -1];
  return run && moment ? moment.time * 1e6 - run.begin : null;
}
function sinceGate({ track, scene: { moment } }: Side): number | null {
  const run = track.drive?.runs[moment?.run ?? -1];
  if (!run || !moment || run.gate_out === null || moment.time * 1e6 < run.gate_out) return null;
  return Math.min(moment.time * 1e6, run.gate_in ?? Infinity) - run.gate_out;
}

function rowsOf(sides: Side[]): Row[] {
  if (sides.every(({ track }) => track.drive)) return driven;
  const rows = [...now, ...(sides.some(isMms) ? [seconds] : []), ...whole, ...countRows(sides)];
  return sides.every(isMms) ? rows.filter(({ label }) => !ofSteps.has(label)) : rows;
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

/** Scores of two worlds, or of two mazes, have no difference that means anything. */
const areComparable = ([one, other]: Side[]) =>
  one.track.play.world === other.track.play.world && isSameMaze(one.track.play, other.track.play);

export function createFacts(state: State): Panel {
  const element = h('section', { class: 'facts' });
  let sides: Side[] = [];
  let compared = false;
  let live: { row: Row; cells: Text[] }[] = [];

  const texts = (row: Row) => {
    const values = sides.map((side) => row.text(side, row.value?.(side) ?? null));
    return compared ? [...values, difference(row, sides)] : values;
  };
  function tableRow(row: Row): HTMLElement {
    const cells = texts(row).map((text) => document.createTextNode(text));
    if (row.live) live.push({ row, cells });
    return h(
      'tr',
      {},
      h('th', { scope: 'row', title: row.meaning?.(sides[0]) }, row.label),
      ...cells.map((cell) => h('td', {}, cell)),
    );
  }
  function rebuild() {
    sides = state.sides;
    live = [];
    compared = sides.length === 2 && areComparable(sides);
    const names = sides.map(({ name }) => name);
    const heads = compared ? [...names, names.join(' − ')] : names;
    const head = heads.map((text) => h('th', { scope: 'col', title: text }, text));
    element.replaceChildren(
      h('h3', {}, 'Numbers'),
      h(
        'div',
        { class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Numbers' },
        h(
          'table',
          {},
          h('thead', {}, h('tr', {}, h('td', {}), ...head)),
          h('tbody', {}, ...rowsOf(sides).map(tableRow)),
        ),
      ),
      meanings(rowsOf(sides).map(({ label, meaning }) => [label, meaning?.(sides[0])])),
      ...sides
        .map(({ track }) => track.play.checked && h('p', { class: 'note' }, track.play.checked))
        .filter((p) => p !== ''),
    );
  }
  return {
    element,
    update() {
      if (sides !== state.sides) return rebuild();
      for (const { row, cells } of live) {
        const fresh = texts(row);
        cells.forEach((cell, i) => {
          if (cell.data !== fresh[i]) cell.data = fresh[i];
        });
      }
    },
  };
}
