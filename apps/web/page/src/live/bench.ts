// Runs what is chosen, at once on every change, and shows the walk.
import type { MazeData } from '../core/types';
import { contestOf, type Driven } from '../link/contest';
import { isSameMaze } from '../maze/same';
import type { Camera } from '../maze/camera';
import { createPlayer } from '../player/player';
import { h } from '../ui/dom';
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

/** `refused` hears why a run could not be, and an empty text where it could. */
export function createBench(page: Page, refused: (message: string) => void) {
  const outcome = h('p.verdict', { role: 'status' });
  const compare = h('input', { type: 'checkbox', onchange: () => show() });
  const beside = h('label.check', compare, 'Compare with before');
  const words = h('p.comparison', { 'aria-live': 'polite' });
  const title = h('h2.unseen', 'The walk');
  const lead = h('div.outcome', outcome, h('div.row', beside, words));
  const player = createPlayer(page, lead);
  // Beside the numbers of a walk; until there is one, in place of it.
  const element = h('div.bench', title, outcome, player.element);
  let now: Walk | null = null;
  let before: Walk | null = null;
  let next: { time?: number; look?: Camera } | null = null;

  /** What is shown is of an order before the last one, which was refused. */
  const stale = (is: boolean) => player.element.classList.toggle('stale', is);
  function show() {
    if (!now) return;
    const at = next?.time === undefined ? 'end' : 'start';
    player.show(compare.checked && before ? [before, now] : [now], at, next?.time, next?.look);
    next = null;
  }
  function take(walk: Walk) {
    before = now && now.play.world === walk.play.world && isSameMaze(now.play, walk.play) ? now : null;
    now = walk;
    lead.prepend(outcome);
    refused('');
    stale(false);
    outcome.dataset.state = walk.play.finished ? 'good' : 'bad';
    outcome.title = `best possible: ${walk.play.traits.bound}`;
    outcome.replaceChildren(outcomeInWords(walk));
    words.replaceChildren(before ? comparisonInWords(before, walk) : '');
    compare.disabled = before === null;
    show();
  }
  const latest = createLatest(
    async ({ maze, ...order }: Order): Promise<Walk> => ({ ...order, ...(await runIn(page, { maze, ...order })) }),
    take,
    (error) => {
      const message = errorText(error);
      stale(true);
      outcome.dataset.state = 'bad';
      outcome.title = '';
      outcome.replaceChildren(`Not run: ${message}`);
      refused(message);
    },
    250,
  );
  compare.disabled = true;
  return {
    element,
    run: latest.ask,
    /** What is run next is shown at that moment, and not at its end. */
    begin: (moment: { time?: number; look?: Camera }) => (next = moment),
    moment: player.moment,
    stop: player.stop,
  };
}
