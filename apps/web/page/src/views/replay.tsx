// The view Replay: the player, and at its side what it plays. Until somebody chooses, that is an example.
import type { ComponentChild } from 'preact';
import type { Play } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { contestBehind, contestOf, contestsInMoment, contestsOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import type { Camera } from '../maze/camera';
import { isSameMaze } from '../maze/same';
import { createRoot } from '../ui/root';
import { Beside } from '../replay/beside';
import { ContestChooser, createChooser, type Chooser } from '../replay/chooser';
import { createPlayer, PlayerRoom, type Player } from '../player/player';
import type { Shown } from '../player/side';
import '../styles/replay.css';
import type { Page, View } from '../page/page';

/** The contests that a link names, run again. */
async function playsOf({ core, about }: Page, moment: Moment): Promise<Shown[]> {
  const maze = await mazeAt(core, moment);
  if (!maze || moment.mice.length < 1 || moment.mice.length > 2)
    throw new Error('This link cannot be followed: a replay is of one or two mice in a maze.');
  const plays: Shown[] = [];
  for (const contest of contestsOf(moment, about, maze)) plays.push(await contestOf(core, contest));
  return plays;
}

/** What a link says of contests in one maze; throws in words where it cannot hold them. */
async function placeInLink({ core, about }: Page, plays: Play[]): Promise<Partial<Moment>> {
  const contests = [];
  for (const play of plays) contests.push(await contestBehind(core, play, about));
  const conditions = contests.map(({ budget, drive }) => JSON.stringify([budget, drive]));
  if (!plays.every((play) => isSameMaze(play, plays[0])) || new Set(conditions).size > 1)
    throw new Error('A link holds contests in one maze under the same conditions. Send the records instead.');
  return { ...contestsInMoment(contests, about), ...(await placeOf(core, about, plays[0].maze)) };
}

async function addressFor(page: Page, shown: Shown[], player: Player): Promise<string> {
  if (shown.length === 0) return 'replay';
  const place = await placeInLink(
    page,
    shown.slice(0, 2).map(({ play }) => play),
  );
  return addressOf('replay', { ...place, ...player.moment() });
}

const still = matchMedia('(prefers-reduced-motion: reduce)');

/** A link that was followed goes along, so that a reload of the page leads to this moment. */
function goAlong(linked: Moment | null, now: Partial<Moment>) {
  if (linked && location.hash.startsWith('#replay&'))
    history.replaceState(null, '', `#${addressOf('replay', { ...linked, ...now })}`);
}

/** What the view is given, from a time on and seen from a place. */
interface Given {
  plays: Shown[];
  time?: number;
  look?: Camera;
}

/** The player, with the forms that choose what it plays. */
const Another = ({ chooser, beside }: { chooser: Chooser; beside: () => ComponentChild }) => (
  <div class="another">
    <ContestChooser chooser={chooser} />
    {beside()}
  </div>
);

function createParts(page: Page) {
  const draw = () => player.refresh();
  const chooser = createChooser(page, draw, (plays, asked, time) => {
    // An example is nothing to come back to.
    isExample = !asked;
    if (asked) page.keepPlays(plays);
    show(plays, true, time);
    // Who is on the way elsewhere by now, or asked for less motion, starts it when they like.
    if (!asked && !element.hidden && !still.matches) player.play();
  });
  const beside = () => <Beside page={page} plays={isChosen ? [] : now} shown={(plays) => show(plays)} />;
  function rested() {
    const now = player.moment();
    if (!isExample) page.keepMoment(addressOf('replay', now));
    if (!element.hidden) goAlong(linked, now);
  }
  const player = createPlayer(page, () => <Another {...{ chooser, beside }} />, { rested });
  // The keys are the player's once it has the focus.
  const { element, draw: drawAll } = createRoot('replay', 'Replay', () => (
    <>
      <h2 class="unseen">Replay</h2>
      <PlayerRoom player={player} tabIndex={-1} role="group" aria-label="Player" />
    </>
  ));
  let now: Shown[] = [];
  /** What is shown was not asked for. */
  let [isExample, isChosen] = [true, false];
  /** What the link says that led here; null where none did. */
  let linked: Moment | null = null;
  /** `chosen`: at the side of the player, where the focus stays. */
  function show(plays: Shown[], chosen = false, time?: number, look?: Camera) {
    now = plays;
    linked = null;
    isChosen = chosen;
    isExample &&= chosen;
    if (!chosen) chooser.forget();
    chooser.refresh(chosen);
    player.show(plays, 'start', time, look);
    // The button that was pressed is gone; the keys are the player's now.
    if (!chosen) player.focus();
  }
  drawAll();
  return {
    element,
    chooser,
    player,
    now: () => now,
    refresh: () => chooser.refresh(isChosen),
    /** `link`: what led here, where a link did. */
    open({ plays, time, look }: Given, link: Moment | null = null) {
      show(plays, false, time, look);
      linked = link;
    },
  };
}

export function createReplay(page: Page): View {
  const { element, chooser, player, now, refresh, open } = createParts(page);
  return {
    element,
    shown() {
      if (now().length > 0) return refresh();
      // What a link names is on its way.
      if (!location.hash.startsWith('#replay&')) void chooser.play();
    },
    hidden: player.stop,
    accept: (thing) => open(thing as Given),
    address: () => addressFor(page, now(), player),
    async follow(hash) {
      try {
        const { moment } = readAddress(hash);
        const plays = await playsOf(page, moment);
        page.keepPlays(plays);
        open({ ...moment, plays }, moment);
      } catch (error) {
        if (now().length === 0) void chooser.play();
        throw error;
      }
    },
  };
}
