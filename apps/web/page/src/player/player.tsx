// The player: one contest, or two beside each other on one clock.
import type { Camera } from '../maze/camera';
import type { Tone } from '../maze/palette';
import { render, type ComponentChildren, type ComponentProps } from 'preact';
import type { EarlyPage } from '../page/page';
import '../styles/player.css';
import { fetchBeliefs } from './beliefs';
import { createActions } from './actions';
import { createClock, start, tick, usual } from './clock';
import { createCurves, DriveCurves, type Curves } from './curves';
import { Facts } from './facts';
import { mazeText } from './figures';
import { Files } from './files';
import { KeyHelp, listen } from './keys';
import { LastWords } from './last-words';
import { usualLayers, type Layers } from './layers';
import { Legend } from './legend';
import { count, createMeter } from './meter';
import { PartingPoint } from './parting-panel';
import { Reasons } from './reasons';
import { Runs } from './runs';
import { Contest, createSide, type Shown } from './side';
import type { Actions, PanelProps, Side, State } from './state';
import { Steps } from './steps';
import { Transport } from './transport';
import { momentText, namesOf } from './words';

export type Player = ReturnType<typeof createPlayer>;

/** The same for all players, and kept from play to play. */
const layers: Layers = { ...usualLayers };

/** Whether anything is known of what the mouse knew. */
const believes = ({ track }: Pick<Side, 'track'>) => track.play.known.length > 0;

const tonesOfTwo: Tone[] = ['to-goal', 'route'];

/** Milliseconds between two looks of the numbers and lists at a replay that runs. */
const panelPause = 100;
/** Of stillness, before a moment is worth keeping. */
const restPause = 300;

/** What stands above the numbers, at that time of the clock. */
type Lead = (time: number) => ComponentChildren;

/** Numbers, lists and words. */
const Panel = ({ page, curves, ...props }: PanelProps & { page: EarlyPage; curves: Curves }) => (
  <>
    <p class="moment" aria-live={props.state.clock.playing ? 'off' : 'polite'}>
      {props.state.sides.map(momentText).join('\n')}
    </p>
    <PartingPoint {...props} />
    <DriveCurves state={props.state} curves={curves} />
    <Runs {...props} />
    <div class="numbers">
      <Facts {...props} />
      <Reasons {...props} />
    </div>
    <Legend {...props} />
    <div class="below">
      <Steps {...props} />
      <LastWords {...props} />
      <Files page={page} state={props.state} />
      <KeyHelp />
    </div>
  </>
);

interface WholeProps extends PanelProps {
  page: EarlyPage;
  curves: Curves;
  lead: Lead;
}

/** All of a player; without a contest what stands above its numbers. */
const Whole = ({ lead, ...props }: WholeProps) => {
  const { sides, clock } = props.state;
  return (
    <>
      <div class="theatre">
        <div class="sides">
          {sides.map((side) => (
            <Contest key={side.track} side={side} />
          ))}
        </div>
        <div class="transport">{sides.length > 0 && <Transport {...props} />}</div>
      </div>
      <div class="panel">
        {lead(clock.time)}
        <div class="parts">{sides.length > 0 && <Panel {...props} />}</div>
      </div>
    </>
  );
};

/** Frames of the browser, as long as the clock runs; `rested` hears of those in which it stands. */
function createLoop(state: State, draw: () => void, curves: () => Curves, rested: () => void) {
  const { clock } = state;
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  const meter = createMeter();
  let asked = 0;
  let told = 0;
  let dirty = true;
  function refresh() {
    dirty = false;
    draw();
  }
  /** Makes nothing while the frame of the replay stays the same. */
  function frame(now: number) {
    const begin = performance.now();
    asked = 0;
    // What was shown may be gone since the frame was asked for.
    if (state.sides.length === 0) return;
    tick(clock, now);
    for (const { scene, track } of state.sides)
      // In seconds the numbers change between the frames, too.
      if (scene.show(clock.time, !still.matches) || track.drive) dirty = true;
    curves().tick();
    if (!clock.playing) rested();
    if (!clock.playing || (dirty && now - told >= panelPause)) {
      told = now;
      refresh();
    }
    if (clock.playing && !document.hidden) asked = requestAnimationFrame(frame);
    count(meter, performance.now() - begin);
  }
  function wake() {
    if (!asked && state.sides.length > 0) asked = requestAnimationFrame(frame);
  }
  document.addEventListener('visibilitychange', () => document.hidden || !clock.playing || wake());
  return { meter, wake, refresh };
}

/** Fetches what the mice believed, where that is known and not there yet. */
async function fetchMissing(page: EarlyPage, { sides }: State, actions: Actions) {
  for (const { track, scene } of sides) {
    if (scene.beliefs() || !believes({ track })) continue;
    try {
      scene.setBeliefs(await fetchBeliefs(page.core, track));
    } catch (error) {
      page.complain(error);
      return actions.setLayers({ distances: 'none' });
    }
  }
}

/** Puts one or two contests into the state. `looked` hears of a closer look at one of them. */
function setSides(state: State, plays: Shown[], looked: (side: number, camera: Camera) => void) {
  const two = plays.slice(0, 2);
  const names = namesOf(two.map(({ play }) => play));
  state.sides = two.map((shown, i) =>
    createSide(shown, names[i], layers, {
      looked: (camera) => looked(i, camera),
      // Two mice differ by tone, as on the home page; one needs none.
      hue: two.length > 1 ? tonesOfTwo[i] : undefined,
    }),
  );
  state.chosen = 0;
  const fastest = Math.max(...state.sides.map(({ track }) => track.drive?.fastest ?? 0));
  for (const { track } of state.sides) if (track.drive) track.drive.fastest = fastest;
}

/** The clock of those contests, standing. */
function setClock({ clock, sides }: State, at: 'start' | 'end', time: number) {
  clock.playing = false;
  clock.end = Math.max(0, ...sides.map(({ track }) => track.time[track.last]));
  clock.time = at === 'end' ? clock.end : Math.min(time, clock.end);
  const inSteps = sides.some(({ track }) => track.play.traits.clock === 'steps');
  clock.unit = inSteps ? usual.steps : usual.seconds;
}

/** As wide as the maze is, with as much height as there is. */
function setShape(element: HTMLElement, { sides }: State) {
  const { width, height } = sides[0]?.track.maze ?? { width: 1, height: 1 };
  element.hidden = sides.length === 0;
  element.classList.toggle('double', sides.length === 2);
  element.style.setProperty('--aspect', String(width / height));
}

/** Who looks closer at one of two mazes of one size looks so at the other. */
function lookTogether({ sides }: State, from: number, camera: Camera) {
  const size = ({ track: { maze } }: Side) => `${maze.width}x${maze.height}`;
  for (const [i, side] of sides.entries())
    if (i !== from && size(side) === size(sides[from])) side.scene.stage.look(camera);
}

/** Whether what the mice believed is to be shown; where nothing is known of that, the true distances are. */
function keepsBelieved({ layers, sides }: State): boolean {
  if (layers.distances === 'believed' && !sides.some(believes)) layers.distances = 'true';
  return layers.distances === 'believed';
}

/** Who hears of a player. */
interface Listeners {
  /** Whenever the clock stands still in another moment. */
  rested?(): void;
  /** With the time after each drawing of the numbers. */
  drawn?(time: number): void;
}

/** Calls once it was not called for a while; some calls come with every frame while somebody scrubs. */
function later(act: () => void) {
  let waiting: ReturnType<typeof setTimeout> | undefined;
  return () => {
    clearTimeout(waiting);
    waiting = setTimeout(act, restPause);
  };
}

/** `lead` stands above the numbers. */
export function createPlayer(page: EarlyPage, lead: Lead = () => null, { rested, drawn }: Listeners = {}) {
  const clock = createClock();
  const state: State = { clock, layers, sides: [], chosen: 0, folded: false };
  let room: HTMLElement | null = null;
  const rest = later(() => rested?.());
  function draw() {
    if (room) setShape(room, state);
    if (room) render(<Whole {...{ page, state, actions, curves, lead }} />, room);
    if (!clock.playing)
      for (const side of state.sides)
        side.scene.stage.describe(`Maze ${mazeText(side.track.maze)}. ${momentText(side)}`);
    drawn?.(clock.time);
  }
  const { meter, wake, refresh } = createLoop(state, draw, () => curves, rest);
  const believe = () => void fetchMissing(page, state, actions);
  const actions = createActions(state, { room: () => room!, wake, refresh, believe });
  const curves = createCurves(state, actions);

  function looked(from: number, camera: Camera) {
    rest();
    lookTogether(state, from, camera);
  }
  listen(() => room, state, actions);
  return {
    /** Takes its room; see PlayerRoom. */
    enter(next: HTMLElement | null) {
      if (!next && room) render(null, room);
      room = next && Object.assign(next, { meter });
      if (room) draw();
    },
    /** Draws its lead, and all else, anew. */
    refresh,
    focus: () => room?.focus({ preventScroll: true }),
    /** Marks what it shows as older than what was asked for last. */
    setStale: (is: boolean) => void room?.classList.toggle('stale', is),
    isEmpty: () => state.sides.length === 0,
    /** The time of the clock, and where one looks at the chosen maze from. */
    moment: () => ({ time: clock.time, look: state.sides[state.chosen]?.scene.stage.camera() }),
    /** Shows one or two of them, from the beginning or at the end, or from that time on; what was shown before is gone. */
    show(plays: Shown[], at: 'start' | 'end' = 'start', time: number = 0, look?: Camera) {
      setSides(state, plays, looked);
      setClock(state, at, time);
      if (keepsBelieved(state)) believe();
      refresh();
      // Once its caption is there the stage has its size, and what is beyond a border does not depend on when it came.
      if (look) state.sides[0]?.scene.stage.look(look);
      if (look) looked(0, look);
      wake();
    },
    /** Plays on from where it is. */
    play: () => (start(clock), wake()),
    /** Pauses: call it when the player is hidden. */
    stop() {
      clock.playing = false;
      wake();
    },
    seek: actions.seek,
  };
}

/** Where a player stands. */
export const PlayerRoom = ({ player, ...more }: { player: Player } & ComponentProps<'div'>) => (
  <div class="player" ref={player.enter} {...more} />
);
