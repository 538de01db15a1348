// What came of a run or a race: the contest on the stage, and the standings.
import { addressOf, type Moment } from '../link/address';
import { placeOf } from '../link/mazes';
import type { Page } from '../page/page';
import { createPlayer, PlayerRoom } from '../player/player';
import type { ContestOutput, Print } from './contest';
import type { Controls } from './controls';
import type { Desk } from './desk';
import { markedAt } from './prints';
import type { Raced } from './racing';
import { placeInWords, Standings } from './standings';
import { failedAt, outcomeInWords } from './words';

export type Display = ReturnType<typeof createDisplay>;

type ContestDisplay = ReturnType<typeof createContestDisplay>;

function createContestDisplay(page: Page, desk: Desk, controls: Controls, draw: () => void) {
  const state = {
    prints: [] as Print[],
    /** What was printed last at the time of the player. */
    marked: -1,
    /** The race that is shown, and of which program. */
    race: null as { raced: Raced; text: string } | null,
    /** What was asked for last stands first. */
    isRaceFirst: false,
  };
  /** What the player shows, and of which program. */
  let shown: { held: ContestOutput; text: string } | null = null;

  /** What a link says of it, beside the program. */
  async function moment() {
    if (!shown) return '';
    const place = await placeOf(page.core, page.about, shown.held.play.maze);
    const same = shown.text === desk.work()?.text;
    return addressOf('', { ...place, ...(same && player.moment()) });
  }
  /** For when the page is opened again. */
  async function keep() {
    if (shown) await page.shelf.write('write', { text: shown.text, at: `write${await moment()}` });
  }
  /** What was seen is of another program. */
  function clear() {
    shown = null;
    Object.assign(state, { prints: [], marked: -1, race: null });
    controls.set({ verdict: null, isNew: true });
    player.show([]);
    desk.fail(null);
  }
  /** A contest of that program. */
  function show(held: ContestOutput, text: string, at?: Moment) {
    Object.assign(state, { prints: held.prints, marked: -1, isRaceFirst: false });
    controls.set({ isNew: false });
    controls.say(outcomeInWords(held, shown?.held.play), held.play.finished ? 'good' : 'bad');
    if (at?.time !== undefined) player.show([held], 'start', at.time, at.look);
    else player.show([held], 'end', 0, at?.look);
    shown = { held, text };
    desk.fail(failedAt(held));
    void keep();
  }
  function drawn(time: number) {
    const marked = markedAt(state.prints, time);
    if (marked === state.marked) return;
    state.marked = marked;
    draw();
  }
  const player = createPlayer(page, undefined, { rested: () => void keep(), drawn });
  return {
    state,
    player,
    moment,
    clear,
    show,
  };
}

/** The race of a program above the player, or below it; one of its contests is shown by `open`. `view` is the whole view. */
function createStandings(page: Page, desk: Desk, controls: Controls, contest: ContestDisplay, view: () => HTMLElement) {
  const { state, show, clear } = contest;
  const bring = (part: string, options?: ScrollIntoViewOptions) => view().querySelector(part)?.scrollIntoView(options);
  return {
    /** Of a program that races nowhere there is nothing on the stage, and what was there is of another one. */
    showNoStart(held: ContestOutput) {
      clear();
      state.prints = held.prints;
      controls.say(outcomeInWords(held), 'bad');
      desk.fail(failedAt(held));
    },
    showRace(raced: Raced, text: string) {
      const { contests } = raced.now;
      const [words, finishedAll] = placeInWords(raced);
      const worst = contests.find(({ play }) => !play.finished);
      Object.assign(state, { race: { raced, text }, isRaceFirst: true });
      controls.say(words, finishedAll ? 'good' : 'bad');
      const message = `The race of ${contests[0].play.mouse} is over.`;
      page.hold(raced.results, raced.mazes, message, undefined, raced.records);
      if (worst) desk.fail(failedAt(worst));
      bring('.standings', { block: 'nearest' });
    },
    open(held: ContestOutput) {
      controls.mazes.pick(held.play.maze.name);
      show(held, state.race!.text);
      bring('.player');
    },
  };
}

/** `draw` is called after each change. */
export function createDisplay(page: Page, desk: Desk, controls: Controls, draw: () => void, view: () => HTMLElement) {
  const contest = createContestDisplay(page, desk, controls, draw);
  return { ...contest, ...createStandings(page, desk, controls, contest, view) };
}

export function DisplayRoom({ display: { state, player, open } }: { display: Display }) {
  const { race, isRaceFirst } = state;
  const parts = [
    race && <Standings key="standings" raced={race.raced} open={open} />,
    <PlayerRoom key="player" player={player} />,
  ];
  return <div class="bench">{isRaceFirst ? parts : parts.reverse()}</div>;
}
