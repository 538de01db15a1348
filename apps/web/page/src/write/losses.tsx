// Steps that a program lost in each maze; each contest is a click away from its replay.
import { number } from '../ui/format';
import { Scrolling, Table } from '../ui/table';
import type { ContestOutput } from './contest';
import { Button } from '../ui/controls';

/** How far a contest stayed behind the best possible score; a failed one lost all. */
const lossOf = ({ play }: ContestOutput) =>
  play.score === null || play.bound === null ? Infinity : play.score - play.bound;

const heads: [head: string, title: string][] = [
  ['maze', 'Choose one to see the contest'],
  ['score', 'speed-run steps + search steps / 30; lower is better'],
  ['best', 'the best possible score of this maze'],
  ['lost', 'the score above the best possible'],
  ['search steps', 'each costs a thirtieth of a step of the speed run'],
  ['speed run excess', 'steps of the speed run above those of the shortest one'],
];

interface Props {
  contests: ContestOutput[];
  /** Shows a contest. */
  open(held: ContestOutput): void;
}

/** The most costly maze first. */
export function Losses({ contests, open }: Props) {
  const sorted = [...contests].sort((a, b) => lossOf(b) - lossOf(a));
  const row = (held: ContestOutput) => {
    const { play } = held;
    return [
      <Button label={play.maze.name} act={() => open(held)} />,
      play.finished ? number(play.score, 1) : play.outcome,
      number(play.bound, 1),
      number(lossOf(held), 1),
      play.finished ? String(play.search_steps) : '–',
      play.finished && play.optimum !== null ? String(play.speed_steps - play.optimum) : '–',
    ];
  };
  return (
    <Scrolling label="Steps lost in each maze" class="losses">
      <Table heads={heads} rows={sorted.map(row)} />
    </Scrolling>
  );
}
