// What follows from a robot, in tables and drawings, beside the robot that it began from.
import type { ComponentChildren } from 'preact';
import type { RobotResult, RobotRoute, RobotTurn } from '../core/types';
import { Table } from '../ui/table';

interface ChangedProps {
  now: number;
  was: number | null | undefined;
  unit?: string;
  digits: number;
}

/** `220.40 ms`, and what it was before where that is another. All figures of a kind have as many digits. */
export function Changed({ now, was, unit, digits }: ChangedProps) {
  const text = unit ? `${now.toFixed(digits)} ${unit}` : now.toFixed(digits);
  if (was === null || was === undefined || was.toFixed(digits) === now.toFixed(digits)) return <span>{text}</span>;
  return (
    <span class="changed">
      {text}
      <small> was {was.toFixed(digits)}</small>
    </span>
  );
}

const Wall = ({ ends: [x1, y1, x2, y2], kind }: { ends: [number, number, number, number]; kind: string }) => (
  <line class={kind} x1={x1} y1={2 - y1} x2={x2} y2={2 - y2} />
);

const points = (path: RobotTurn['path']) => path.map(([x, y]) => `${x},${2 - y}`).join(' ');

interface TurnProps {
  turn: RobotTurn;
  before: RobotTurn | undefined;
}

/** The path among its walls, over that of the robot it began from. */
function Path({ turn: { turn, path, open, standing }, before }: TurnProps) {
  const [end, last] = [path[path.length - 1], path[path.length - 2]];
  const angle = (Math.atan2(end[0] - last[0], end[1] - last[1]) * 180) / Math.PI;
  return (
    <svg viewBox="-0.1 -0.1 2.2 2.2" role="img" aria-label={`The path of turn ${turn} among its walls`}>
      {open.map((wall) => (
        <Wall ends={wall} kind="open" />
      ))}
      {standing.map((wall) => (
        <Wall ends={wall} kind="standing" />
      ))}
      {before && points(before.path) !== points(path) && <polyline class="before" points={points(before.path)} />}
      <polyline class="path" points={points(path)} />
      <circle class="from" cx={path[0][0]} cy={2 - path[0][1]} r={0.05} />
      <path
        class="to"
        d="M0 -0.09L0.07 0.06L-0.07 0.06Z"
        transform={`translate(${end[0]} ${2 - end[1]}) rotate(${angle})`}
      />
    </svg>
  );
}

const lengths: [key: 'lead_in' | 'lead_out' | 'length' | 'clearance', name: string][] = [
  ['lead_in', 'straight before'],
  ['lead_out', 'straight after'],
  ['length', 'curve'],
  ['clearance', 'room to posts'],
];

const TurnFigure = ({ turn, before }: TurnProps) => (
  <figure class="robot-turn" data-turn={turn.turn}>
    <Path turn={turn} before={before} />
    <figcaption>
      <strong>{turn.turn}</strong>
    </figcaption>
    <Table
      label={`Speeds of turn ${turn.turn}`}
      heads={['mm/s', 'ms']}
      rows={turn.speeds.map(({ speed, ms }, i) => [
        <Changed now={speed} was={before?.speeds[i]?.speed} digits={1} />,
        <Changed now={ms} was={before?.speeds[i]?.ms} digits={3} />,
      ])}
    />
    <dl class="figures">
      {lengths
        .filter(([key]) => turn[key] !== null)
        .map(([key, name]) => (
          <>
            <dt>{name}</dt>
            <dd>
              <Changed now={turn[key]!} was={before?.[key]} unit="mm" digits={1} />
            </dd>
          </>
        ))}
    </dl>
  </figure>
);

/** What follows from a robot, and from the one that it began from; null where they are the same. */
interface ResultProps {
  result: RobotResult;
  before: RobotResult | null;
}

export const Turns = ({ result: { turns }, before }: ResultProps) => (
  <div class="robot-turns">
    {turns.map((turn) => (
      <TurnFigure turn={turn} before={before?.turns.find((one) => one.turn === turn.turn)} />
    ))}
  </div>
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

type Row = [name: string, value: ComponentChildren];
const List = ({ label, rows }: { label: string; rows: Row[] }) => (
  <div class="scroll">
    <Table label={label} rows={rows} />
  </div>
);

const ms = (now: number, was: number | undefined) => <Changed now={now} was={was} unit="ms" digits={3} />;

/** Straights between turns, and the moves of a search. */
export const Tables = ({ result: { straights, search }, before }: ResultProps) => (
  <div class="robot-tables">
    {straights.map(({ kind, step, speed, times }) => {
      const was = before?.straights.find((one) => one.kind === kind)?.times;
      const name = kind === 'straight' ? 'Straights' : 'Diagonals';
      return (
        <div>
          <h4>
            {name} between turns at {speed.toFixed(0)} mm/s
          </h4>
          <List
            label={`Times of ${name.toLowerCase()}`}
            rows={times.map((time): Row => {
              const earlier = was?.find((one) => one.steps === time.steps)?.ms;
              return [`${time.steps} ${step}`, ms(time.ms, earlier)];
            })}
          />
        </div>
      );
    })}
    <div>
      <h4>Moves of a search</h4>
      <List
        label="Moves of a search"
        rows={moves.map(([key, name]): Row => [name, ms(search[key], before?.search[key])])}
      />
    </div>
  </div>
);

type Time = 'time_us' | 'gate_to_gate_us' | 'without_diagonals_us' | 'small_turns_us';

const routeTimes: [Time, string][] = [
  ['time_us', 'from rest to the centre of the goal'],
  ['gate_to_gate_us', 'gate to gate: from leaving the start cell to entering a goal'],
  ['without_diagonals_us', 'the best without diagonals'],
  ['small_turns_us', 'the best with S90 alone, the small turn of a search'],
];

const seconds = (microseconds: number | null | undefined) =>
  microseconds === null || microseconds === undefined ? null : microseconds / 1e6;

/** The times of the best route, with those of the robot it began from. */
export function RouteTable({ route, before }: { route: RobotRoute; before: RobotRoute | null }) {
  const times = routeTimes.flatMap(([key, name]): Row[] => {
    const now = seconds(route[key]);
    return now === null ? [] : [[name, <Changed now={now} was={seconds(before?.[key])} unit="s" digits={3} />]];
  });
  return (
    <List
      label="The best route"
      rows={[...times, [`cells entered, at least ${route.fewest_cells}`, <span>{route.cells}</span>]]}
    />
  );
}
