// What came of a run or a race: the contest on the stage, and the standings.
import { addressOf, type Moment } from '../link/address';
import { placeOf } from '../link/mazes';
import type { Page } from '../page/page';
import { createPlayer } from '../player/player';
import { h } from '../ui/dom';
import type { ContestOutput } from './contest';
import type { Controls } from './controls';
import type { Desk } from './desk';
import type { Prints } from './prints';
import type { Raced } from './racing';
import { placeInWords, standingsOf } from './standings';
import { failedAt, outcomeInWords } from './words';

export type Display = ReturnType<typeof createDisplay>;

export function createDisplay(page: Page, desk: Desk, controls: Controls, prints: Prints) {
  const player = createPlayer(page, prints);
  // The player updates it; it stands here, where it is seen also without a contest on the stage.
  controls.verdict.after(prints);
  const standings = h('section.race.pictures.standings', { 'aria-label': 'Its race', hidden: true });
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
    controls.verdict.hidden = standings.hidden = true;
    controls.hint.hidden = false;
    prints.show([]);
    player.show([]);
    desk.fail(null);
  }
  /** A contest of that program. What was asked for last stands first. */
  function show(held: ContestOutput, text: string, at?: Moment) {
    player.element.after(standings);
    controls.hint.hidden = true;
    controls.say(outcomeInWords(held, shown?.held.play), held.play.finished ? 'good' : 'bad');
    prints.show(held.prints);
    if (at?.time !== undefined) player.show([held], 'start', at.time, at.look);
    else player.show([held], 'end', 0, at?.look);
    shown = { held, text };
    desk.fail(failedAt(held));
    void keep();
  }
  /** Of a program that races nowhere there is nothing on the stage, and what was there is of another one. */
  function showNoStart(held: ContestOutput) {
    clear();
    controls.say(outcomeInWords(held), 'bad');
    prints.show(held.prints);
    desk.fail(failedAt(held));
  }
  player.rested(() => void keep());
  const stage = { player: player.element, standings, show };
  return {
    element: h('div.bench', standings, player.element),
    player,
    moment,
    clear,
    show,
    showNoStart,
    showRace: (raced: Raced, text: string) => showRace(page, desk, controls, stage, raced, text),
  };
}

interface Stage {
  player: HTMLElement;
  standings: HTMLElement;
  show(held: ContestOutput, text: string): void;
}

/** Shows the race of that program above the player. */
function showRace(page: Page, desk: Desk, controls: Controls, stage: Stage, raced: Raced, text: string) {
  const { contests } = raced.now;
  const { player, standings } = stage;
  const [words, finishedAll] = placeInWords(raced);
  const worst = contests.find(({ play }) => !play.finished);
  controls.say(words, finishedAll ? 'good' : 'bad');
  standings.hidden = false;
  player.before(standings);
  const open = (held: ContestOutput) => {
    stage.show(held, text);
    controls.mazes.refresh(held.play.maze.name);
    player.scrollIntoView();
  };
  standings.replaceChildren(...standingsOf(raced, open));
  const message = `The race of ${contests[0].play.mouse} is over.`;
  page.hold(raced.results, raced.mazes, message, undefined, raced.records);
  if (worst) desk.fail(failedAt(worst));
  standings.scrollIntoView({ block: 'nearest' });
}
