// What follows from a robot, in tables and drawings, beside the robot that it began from.
import type { RobotResult, RobotRoute, RobotTurn } from '../core/types';
import { h, svg } from '../ui/dom';
import { table } from '../ui/table';

/** `220.40 ms`, and what it was before where that is another. All figures of a kind have as many digits. */
export function changedText(now: number, before: number | null | undefined, unit: string, digits: number) {
  const text = unit === '' ? now.toFixed(digits) : `${now.toFixed(digits)} ${unit}`;
  if (before === null || before === undefined || before.toFixed(digits) === now.toFixed(digits)) return h('span', text);
  return h('span.changed', text, h('small', ` was ${before.toFixed(digits)}`));
}

const line = ([x1, y1, x2, y2]: [number, number, number, number], kind: string) =>
  svg('line', { class: kind, x1, y1: 2 - y1, x2, y2: 2 - y2 });

const points = (path: RobotTurn['path']) => path.map(([x, y]) => `${x},${2 - y}`).join(' ');

/** The path among its walls, over that of the robot it began from. */
function drawing({ turn, path, open, standing }: RobotTurn, before: RobotTurn | undefined) {
  const [end, last] = [path[path.length - 1], path[path.length - 2]];
  const angle = (Math.atan2(end[0] - last[0], end[1] - last[1]) * 180) / Math.PI;
  return svg(
    'svg',
    { viewBox: '-0.1 -0.1 2.2 2.2', role: 'img', 'aria-label': `The path of turn ${turn} among its walls` },
    ...open.map((wall) => line(wall, 'open')),
    ...standing.map((wall) => line(wall, 'standing')),
    before && points(before.path) !== points(path)
      ? svg('polyline', { class: 'before', points: points(before.path) })
      : null,
    svg('polyline', { class: 'path', points: points(path) }),
    svg('circle', { class: 'from', cx: path[0][0], cy: 2 - path[0][1], r: 0.05 }),
    svg('path', {
      class: 'to',
      d: 'M0 -0.09L0.07 0.06L-0.07 0.06Z',
      transform: `translate(${end[0]} ${2 - end[1]}) rotate(${angle})`,
    }),
  );
}

function turnFigure(turn: RobotTurn, before: RobotTurn | undefined) {
  const mm = (name: string, value: number | null, was: number | null | undefined) =>
    value === null ? [] : [h('dt', name), h('dd', changedText(value, was, 'mm', 1))];
  const speeds = turn.speeds.map(({ speed, ms }, i) =>
    h(
      'tr',
      h('td', changedText(speed, before?.speeds[i]?.speed, '', 1)),
      h('td', changedText(ms, before?.speeds[i]?.ms, '', 3)),
    ),
  );
  return h(
    'figure.robot-turn',
    { 'data-turn': turn.turn },
    drawing(turn, before),
    h('figcaption', h('strong', turn.turn)),
    h(
      'table',
      { 'aria-label': `Speeds of turn ${turn.turn}` },
      h('thead', h('tr', h('th', { scope: 'col' }, 'mm/s'), h('th', { scope: 'col' }, 'ms'))),
      h('tbody', ...speeds),
    ),
    h(
      'dl.figures',
      ...mm('straight before', turn.lead_in, before?.lead_in),
      ...mm('straight after', turn.lead_out, before?.lead_out),
      ...mm('curve', turn.length, before?.length),
      ...mm('room to posts', turn.clearance, before?.clearance),
    ),
  );
}

export const turnFigures = ({ turns }: RobotResult, before: RobotResult | null) =>
  turns.map((turn) =>
    turnFigure(
      turn,
      before?.turns.find((one) => one.turn === turn.turn),
    ),
  );

const moves: [keyof RobotResult['search'], string][] = [
  ['cell', 'a cell straight on'],
  ['turn', 'a quarter turn inside a cell'],
  ['back', 'into a cell, around, and out again'],
  ['quarter', 'a quarter turn on the spot'],
  ['half_cell', 'half a cell, from rest or to rest'],
  ['known_2', 'two known cells straight on'],
  ['known_8', 'eight known cells straight on'],
];

type Row = [name: string, value: HTMLElement];
const listOf = (label: string, rows: Row[]) => h('div.scroll', table({ 'aria-label': label }, [], rows));

export const searchTable = ({ search }: RobotResult, before: RobotResult | null) =>
  listOf(
    'Moves of a search',
    moves.map(([key, name]) => [name, changedText(search[key], before?.search[key], 'ms', 3)]),
  );

export function straightTables({ straights }: RobotResult, before: RobotResult | null) {
  return straights.map(({ kind, step, speed, times }) => {
    const was = before?.straights.find((one) => one.kind === kind)?.times;
    return h(
      'div',
      h('h4', `${kind === 'straight' ? 'Straights' : 'Diagonals'} between turns at ${speed.toFixed(0)} mm/s`),
      listOf(
        `Times of ${kind === 'straight' ? 'straights' : 'diagonals'}`,
        times.map(({ steps, ms }) => [
          `${steps} ${step}`,
          changedText(ms, was?.find((one) => one.steps === steps)?.ms, 'ms', 3),
        ]),
      ),
    );
  });
}

const seconds = (microseconds: number | null | undefined) =>
  microseconds === null || microseconds === undefined ? null : microseconds / 1e6;

/** The times of the best route, with those of the robot it began from. */
export function routeTable(route: RobotRoute, before: RobotRoute | null) {
  const time = (
    name: string,
    key: 'time_us' | 'gate_to_gate_us' | 'without_diagonals_us' | 'small_turns_us',
  ): Row[] => {
    const now = seconds(route[key]);
    return now === null ? [] : [[name, changedText(now, seconds(before?.[key]), 's', 3)]];
  };
  return listOf('The best route', [
    ...time('from rest to the centre of the goal', 'time_us'),
    ...time('gate to gate: from leaving the start cell to entering a goal', 'gate_to_gate_us'),
    ...time('the best without diagonals', 'without_diagonals_us'),
    ...time('the best with S90 alone, the small turn of a search', 'small_turns_us'),
    [`cells entered, at least ${route.fewest_cells}`, h('span', `${route.cells}`)],
  ]);
}
