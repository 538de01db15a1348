// The home page: a race that is already running, what this is, and where to go from here.
import { createFrontRace, Race, type FrontRace } from '../home/race';
import { meet, pairs, type Met } from '../home/pairs';
import { addressOf, readAddress } from '../link/address';
import { Icon, type IconName } from '../player/icons';
import { createRoot } from '../ui/root';
import type { EarlyPage, View } from '../page/page';
import '../styles/home.css';
import { Button } from '../ui/controls';

/** What this is, and where to go from here. */
const Intro = ({ watch }: { watch: (() => void) | null }) => (
  <div class="intro">
    <p>
      <strong>In labmouse, micromouse programs race through mazes that they have never seen</strong>: each draws its own
      map, follows the route that it plans (the dots), then makes its speed run.
    </p>
    <div class="row">
      <Button label="Watch" class="main" disabled={!watch} act={() => watch?.()} />
      <a class="button" href="#race">
        Race
      </a>
      <a class="button" href="#write">
        Write your own
      </a>
    </div>
  </div>
);

const Sign = ({ label, icon, act }: { label: string; icon: IconName; act: () => void }) => (
  <button type="button" aria-label={label} title={label} onClick={act}>
    <Icon name={icon} />
  </button>
);

/** The place of the pair that a link names, from 1 on. */
function indexOf(pair = 1): number {
  if (pair <= pairs.length) return pair - 1;
  throw new Error(`This link cannot be followed: there are ${pairs.length} races on the home page.`);
}

interface ContentProps {
  page: EarlyPage;
  race: FrontRace;
  now: [Met, Met] | null;
  /** Stops the race, or lets it go on. */
  wait(yes: boolean): void;
  next(): void;
}

function Content({ page, race, now, wait, next }: ContentProps) {
  const running = race.isRunning();
  return (
    <>
      <Intro watch={now && (() => page.replay(now, race.time()))} />
      <Race race={race}>
        <Sign label={running ? 'Pause' : 'Run'} icon={running ? 'pause' : 'play'} act={() => wait(running)} />
        <Sign label="Another race" icon="end" act={next} />
      </Race>
    </>
  );
}

const still = matchMedia('(prefers-reduced-motion: reduce)');

export function createHome(page: EarlyPage): View {
  let next = 0;
  let now: [Met, Met] | null = null;
  let isShown = false;
  /** Somebody stopped it, or asked for less motion: it waits. */
  let waits = still.matches;

  const { element, draw } = createRoot('home', 'Home', () => (
    <Content {...{ page, race, now, wait }} next={() => void begin()} />
  ));
  const race = createFrontRace(
    () => draw(),
    () => void begin(),
  );
  function go() {
    if (isShown && !waits && !document.hidden) race.run();
    else race.pause();
    draw();
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
  function look(yes: boolean) {
    isShown = yes;
    wake();
  }
  async function begin(from?: number) {
    try {
      const met = await meet(page.core, pairs[next++ % pairs.length]);
      now = met;
      race.set(page.core, met, from);
      go();
    } catch (error) {
      // What keeps the core from starting is said by the page itself.
      if (await page.ready.catch(() => null)) page.complain(error);
    }
  }
  still.addEventListener('change', () => wait(still.matches));
  document.addEventListener('visibilitychange', wake);
  draw();
  return {
    element,
    shown: () => look(true),
    address: async () => addressOf('home', { pair: ((next + pairs.length - 1) % pairs.length) + 1, time: race.time() }),
    async follow(hash) {
      const { pair, time } = readAddress(hash).moment;
      next = indexOf(pair);
      await begin(time);
    },
    hidden: () => look(false),
  };
}
