// Runs what is chosen, at once on every change, and shows the walk.
import type { MazeData } from '../core/types';
import { contestOf, type Driven } from '../link/contest';
import { isSameMaze } from '../maze/same';
import type { Camera } from '../maze/camera';
import { createPlayer, PlayerRoom } from '../player/player';
import { Check } from '../ui/controls';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';
import { comparisonInWords, type Walk } from './comparison';
import { errorText } from '../ui/format';

export interface Order {
  spec: string;
  maze: MazeData;
  seed: number;
  budget: number;
  /** For a contest in seconds, which has no budget of steps. */
  drive: Driven | null;
}

export type Bench = ReturnType<typeof createBench>;

const score = (value: number | null, unit: string) => (value === null ? 'none' : value.toFixed(3) + unit);

/** What came of a walk, in a line. */
function outcomeInWords({ spec, play }: Walk): string {
  const unit = play.traits.unit && ` ${play.traits.unit}`;
  const known = play.bound === null ? 'no goal can be reached' : `best possible ${score(play.bound, unit)}`;
  return `${spec} in ${play.maze.name || 'this maze'}: ${play.outcome}, score ${score(play.score, unit)}, ${known}`;
}

const runIn = ({ core }: Page, { spec, drive, ...order }: Order) =>
  contestOf(core, { ...order, mouse: spec, drive: drive ?? undefined });

/** `refused` hears why a run could not be, and an empty text where it could; then the view is drawn. */
export function createBench(page: Page, refused: (message: string) => void) {
  const state = {
    outcome: { words: '', title: '', kind: undefined as 'good' | 'bad' | undefined },
    /** What was run last, and before it in the same maze. */
    now: null as Walk | null,
    before: null as Walk | null,
    isCompared: false,
  };
  let next: { time?: number; look?: Camera } | null = null;
  const player = createPlayer(page, () => <Lead bench={bench} />);

  function show() {
    const { now, before, isCompared } = state;
    if (!now) return;
    const at = next?.time === undefined ? 'end' : 'start';
    player.show(isCompared && before ? [before, now] : [now], at, next?.time, next?.look);
    next = null;
  }
  /** `stale`: what is shown is of an order before the last one, which was refused. */
  function tell(words: string, title: string, isGood: boolean, stale: boolean, message: string) {
    state.outcome = { words, title, kind: isGood ? 'good' : 'bad' };
    player.setStale(stale);
    refused(message);
  }
  function take(walk: Walk) {
    const { now } = state;
    state.before = now && now.play.world === walk.play.world && isSameMaze(now.play, walk.play) ? now : null;
    state.now = walk;
    const { finished, traits } = walk.play;
    tell(outcomeInWords(walk), `best possible: ${traits.bound}`, finished, false, '');
    show();
  }
  const latest = createLatest(
    async ({ maze, ...order }: Order): Promise<Walk> => ({ ...order, ...(await runIn(page, { maze, ...order })) }),
    take,
    (error) => {
      const message = errorText(error);
      tell(`Not run: ${message}`, '', false, true, message);
      player.refresh();
    },
    250,
  );
  const bench = {
    state,
    player,
    compare(is: boolean) {
      state.isCompared = is;
      show();
    },
    run: latest.ask,
    /** What is run next is shown at that moment, and not at its end. */
    begin: (moment: { time?: number; look?: Camera }) => (next = moment),
  };
  return bench;
}

const Outcome = ({ bench: { state } }: { bench: Bench }) => (
  <p class="verdict" role="status" data-state={state.outcome.kind} title={state.outcome.title}>
    {state.outcome.words}
  </p>
);

/** Beside the numbers of a walk. */
const Lead = ({ bench }: { bench: Bench }) => {
  const { now, before, isCompared } = bench.state;
  return (
    <div class="outcome">
      {now && <Outcome bench={bench} />}
      <div class="row">
        <Check label="Compare with before" checked={isCompared} disabled={!before} change={bench.compare} />
        <p class="comparison" aria-live="polite">
          {now && before && comparisonInWords(before, now)}
        </p>
      </div>
    </div>
  );
};

/** Until there is a walk, its outcome stands in the place of the player. */
export const BenchRoom = ({ bench }: { bench: Bench }) => (
  <div class="bench">
    <h2 class="unseen">The walk</h2>
    {!bench.state.now && <Outcome bench={bench} />}
    <PlayerRoom player={bench.player} />
  </div>
);
