// The home page: a race that is already running, what this is, and where to go from here.
import { createFrontRace } from '../home/race';
import { meet, pairs, type Met } from '../home/pairs';
import { addressOf, readAddress } from '../link/address';
import { icon, type IconName } from '../player/icons';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import type { EarlyPage, View } from '../page/page';
import '../styles/home.css';

/** What this is, and where to go from here. */
const introOf = (watch: HTMLElement) =>
  h(
    'div.intro',
    h(
      'p',
      h('strong', 'In labmouse, micromouse programs race through mazes that they have never seen'),
      ': each draws its own map, follows the route that it plans (the dots), then makes its speed run.',
    ),
    h('div.row', watch, h('a.button', { href: '#race' }, 'Race'), h('a.button', { href: '#write' }, 'Write your own')),
  );

const sign = (label: string, act: () => void, ...signs: IconName[]) =>
  h('button', { type: 'button', 'aria-label': label, title: label, onclick: act }, ...signs.map(icon));

/** Shows what the button does now. */
function showToggle(toggle: HTMLElement, running: boolean) {
  toggle.replaceChildren(icon(running ? 'pause' : 'play'));
  toggle.title = running ? 'Pause' : 'Run';
  toggle.setAttribute('aria-label', toggle.title);
}

/** The place of the pair that a link names, from 1 on. */
function indexOf(pair = 1): number {
  if (pair <= pairs.length) return pair - 1;
  throw new Error(`This link cannot be followed: there are ${pairs.length} races on the home page.`);
}

export function createHome(page: EarlyPage): View {
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  let next = 0;
  let now: [Met, Met] | null = null;
  let isShown = false;
  /** Somebody stopped it, or asked for less motion: it waits. */
  let waits = still.matches;

  const toggle = sign('Run', () => wait(race.isRunning()));
  const other = sign('Another race', () => void begin(), 'end');
  const race = createFrontRace(() => void begin(), toggle, other);
  const replay = () => now && page.replay(now, race.time());
  const watch = button('Watch', replay, { class: 'main', disabled: true });

  function go() {
    if (isShown && !waits && !document.hidden) race.run();
    else race.pause();
    showToggle(toggle, race.isRunning());
  }
  function wait(yes: boolean) {
    waits = yes;
    go();
  }
  /** The first race is not even asked for before somebody can see it. */
  function wake() {
    if (now || !isShown || document.hidden) go();
    else if (next === 0) void begin();
  }
  async function begin(from?: number) {
    try {
      const met = await meet(page.core, pairs[next++ % pairs.length]);
      now = met;
      race.set(page.core, met, from);
      watch.disabled = false;
      go();
    } catch (error) {
      // What keeps the core from starting is said by the page itself.
      if (await page.ready.catch(() => null)) page.complain(error);
    }
  }
  still.addEventListener('change', () => wait(still.matches));
  document.addEventListener('visibilitychange', wake);
  return {
    element: h('section.home', { 'aria-label': 'Home' }, introOf(watch), race.element),
    shown() {
      isShown = true;
      wake();
    },
    address: async () => addressOf('home', { pair: ((next + pairs.length - 1) % pairs.length) + 1, time: race.time() }),
    async follow(hash) {
      const { pair, time } = readAddress(hash).moment;
      next = indexOf(pair);
      await begin(time);
    },
    hidden() {
      isShown = false;
      go();
    },
  };
}
