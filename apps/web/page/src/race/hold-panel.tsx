// The form that runs a race in the page.
import type { About, MazeData, WorldInPage } from '../core/types';
import { isSameMaze } from '../maze/same';
import { Button, NumberInput, numberOf } from '../ui/controls';
import { createWorldChoice, WorldFields } from '../choice/world-choice';
import type { EarlyPage } from '../page/page';
import { createMazePicks, createPicks, PickList, usual } from '../choice/picks';
import { groupsOf } from '../results/contests';
import { counted } from '../ui/format';
import { holdRace, type Order, type Progress } from '../results/holding';
import { createRunning } from './running';

export type HoldPanel = ReturnType<typeof createHoldPanel>;

const most = { runs: 100, seed: 2 ** 53 - 1 };

/** Runs a race, and shows its results. */
async function hold(page: EarlyPage, order: Order, report: (progress: Progress) => void, wanted: () => boolean) {
  const held = await holdRace(page.core, order, report, wanted);
  if (!held) return page.tell('The race was stopped.');
  const { results, mazes } = held;
  const mice = groupsOf(results).flatMap((group) => group.mice);
  const entries = `${counted(mice.length, 'mouse', 'mice')}, ${counted(mazes.length, 'maze')}`;
  page.hold(results, mazes, `The race is over: ${entries}.`, order);
}

/** How often, and with which seed, as it is typed. */
function createNumbers(usualRuns: number) {
  const texts = { runs: String(usualRuns), seed: '1' };
  const whole = (text: string, most: number, otherwise: number) =>
    Math.max(1, Math.min(most, Math.round(numberOf(text)) || otherwise));
  return {
    texts,
    read: () => ({ runs: whole(texts.runs, most.runs, usualRuns), seed: whole(texts.seed, most.seed, 1) }),
    write: ({ runs, seed }: { runs?: number; seed?: number }) =>
      void Object.assign(texts, runs && { runs: String(runs) }, seed && { seed: String(seed) }),
  };
}

/** The mice that run in a world, to be chosen. */
const entrantsOf = ({ mice }: About, world: WorldInPage) =>
  mice
    .filter(({ name }) => world.mice.includes(name))
    .map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) }));

/** The mazes to choose from, and `take`: a maze of a link is one of the user's from then on, unless it is that already. */
function createMazes(page: EarlyPage, about: About) {
  const linked: MazeData[] = [];
  const mazes = createMazePicks('Mazes', about, () => [...page.mazes(), ...linked], false);
  function take(maze: MazeData): string {
    for (const [name, mine] of mazes.own()) if (isSameMaze({ maze: mine }, { maze })) return name;
    linked.push(maze);
    mazes.refresh();
    return take(maze);
  }
  return { mazes, take };
}

/** Who races, where, how often: an order, to be read and to be set. `draw` is called after each change. */
export function createHoldPanel(page: EarlyPage, about: About, draw: () => void) {
  const world = createWorldChoice(about, enter);
  let { world: where } = world.chosen();
  const numbers = createNumbers(where.usual_runs);
  const mice = createPicks('Mice', entrantsOf(about, where));
  const { mazes, take } = createMazes(page, about);
  const running = createRunning<Progress>(page, 'race', draw);
  /** Offers what there is in the chosen world: its mice, and as many runs as are usual there, unless others were chosen. */
  function enter() {
    const { usual_runs: before } = where;
    where = world.chosen().world;
    if (numbers.read().runs === before) numbers.write({ runs: where.usual_runs });
    mice.offer(entrantsOf(about, where));
    draw();
  }
  /** What is chosen. */
  function order(): Order {
    const { world: where, settings } = world.chosen();
    const asked = { mice: mice.chosen(), mazes: mazes.chosenMazes(), ...numbers.read() };
    return { ...asked, ...(where !== about.worlds[0] && { world: { ...settings, world: where.name } }) };
  }
  return {
    world,
    mice,
    mazes,
    numbers: numbers.texts,
    running,
    order,
    change(changes: Partial<typeof numbers.texts>) {
      Object.assign(numbers.texts, changes);
      draw();
    },
    /** Offers the mazes that there are by now. */
    refresh() {
      mazes.refresh();
      draw();
    },
    /** Chooses that. */
    set(order: Order) {
      world.choose(order.world?.world, order.world);
      enter();
      mazes.choose(order.mazes.map((maze) => (typeof maze === 'string' ? maze : take(maze))));
      mice.choose(order.mice);
      numbers.write(order);
      draw();
    },
    /** Runs the race that is chosen. */
    start() {
      const asked = order();
      if (asked.mice.length === 0 || asked.mazes.length === 0)
        return page.complain('Choose at least one mouse and one maze.');
      void running.run((report, wanted) => hold(page, asked, report, wanted));
    },
  };
}

export function HoldForm({ panel: { world, mice, mazes, numbers, running, change, start } }: { panel: HoldPanel }) {
  const { isBusy, shown: progress } = running.state;
  const whole = { min: 1, required: true };
  const submit = (event: Event) => {
    event.preventDefault();
    start();
  };
  return (
    <form class="hold" onSubmit={submit}>
      <WorldFields choice={world} />
      <div class="sides">
        <PickList picks={mice} />
        <PickList picks={mazes} />
      </div>
      <div class="row">
        <label class="row">
          <span>{world.chosen().world.is_stochastic ? 'runs of each mouse' : 'runs of stochastic mice'}</span>
          <NumberInput {...whole} max={most.runs} value={numbers.runs} change={(runs) => change({ runs })} />
        </label>
        <label class="row">
          seed
          <NumberInput {...whole} max={most.seed} value={numbers.seed} change={(seed) => change({ seed })} />
        </label>
        <button type="submit" class="main" disabled={isBusy}>
          Start the race
        </button>
      </div>
      <div class="row" hidden={!isBusy}>
        <progress max={progress?.all ?? 1} value={progress?.done ?? 0} aria-label="Progress of the race" />
        <span class="note">{progress && `${progress.doing}, mouse ${progress.done + 1} of ${progress.all}`}</span>
        <Button label="Stop" act={running.stop} />
      </div>
    </form>
  );
}
