// The form that holds a race in the page.
import type { About, MazeData } from '../core/types';
import { isSameMaze } from '../maze/same';
import { h } from '../ui/dom';
import { createWorldChoice } from '../choice/world-choice';
import type { EarlyPage } from '../page/page';
import { namedApart, picks, usual } from '../choice/picks';
import { groupsOf } from '../results/contests';
import { counted } from '../ui/format';
import { holdRace, type Order } from '../results/holding';

const whole = (label: string | Node, value: number, most: number) => {
  const input = h('input', { type: 'number', min: 1, max: most, step: 1, value, required: true });
  const read = () => Math.max(1, Math.min(most, Math.round(input.valueAsNumber) || value));
  return {
    element: h('label', { class: 'row' }, label, input),
    read,
    write: (now: number) => (input.value = String(now)),
  };
};

export interface HoldPanel {
  element: HTMLElement;
  /** Offers the mazes that there are by now. */
  refresh(): void;
  /** What is chosen. */
  order(): Order;
  /** Chooses that. */
  set(order: Order): void;
  /** Holds the race that is chosen. */
  start(): void;
}

/** The form, once it is known what the core brings. */
export function holdPanel(page: EarlyPage, about: About): HoldPanel {
  const world = createWorldChoice(about, enter);
  const entrants = () =>
    about.mice
      .filter(({ name }) => world.chosen().world.mice.includes(name))
      .map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) }));
  const mice = picks('Mice', entrants());
  const builtin = about.mazes.map(({ name, width, height }) => ({ name, about: `${width}×${height}`, on: true }));
  const mazes = picks('Mazes', builtin);
  /** Those of the user, by the names under which they are offered. */
  let own = new Map<string, MazeData>();
  /** Those that came with links. */
  const linked: MazeData[] = [];
  function refresh() {
    const found = namedApart(
      [...page.mazes(), ...linked],
      builtin.map(({ name }) => name),
    );
    own = new Map(found.map((maze) => [maze.name, maze]));
    const offered = found.map(({ name, width, height }) => ({ name, about: `${width}×${height}, yours`, on: false }));
    mazes.offer([...offered, ...builtin]);
  }
  refresh();
  const whose = h('span', {});
  let { world: where } = world.chosen();
  const runs = whole(whose, where.usual_runs, 100);
  const seed = whole('seed', 1, 2 ** 53 - 1);
  /** Offers what there is in the chosen world: its mice, and as many runs as are usual there, unless others were chosen. */
  function enter() {
    const { usual_runs: before } = where;
    where = world.chosen().world;
    if (runs.read() === before) runs.write(where.usual_runs);
    whose.textContent = where.throws_dice ? 'runs of each mouse' : 'runs of mice that throw dice';
    mice.offer(entrants());
  }
  enter();
  const bar = h('progress', { max: 1, value: 0, 'aria-label': 'Progress of the race' });
  const doing = h('span', { class: 'note' });
  const running = h(
    'div',
    { class: 'row', hidden: true },
    bar,
    doing,
    h('button', { type: 'button', onclick: () => stop() }, 'Stop'),
  );
  const begin = h('button', { type: 'submit', class: 'main' }, 'Start the race');
  let wanted = true;

  function stop() {
    wanted = false;
    page.core.stop('race');
  }
  async function hold(order: Order) {
    wanted = true;
    begin.disabled = true;
    running.hidden = false;
    try {
      const held = await holdRace(
        page.core,
        order,
        (now) => {
          bar.max = now.all;
          bar.value = now.done;
          doing.textContent = `${now.doing}, mouse ${now.done + 1} of ${now.all}`;
        },
        () => wanted,
      );
      if (!held) return page.tell('The race was stopped.');
      const { results, mazes: raced } = held;
      const entries = `${counted(groupsOf(results).flatMap((group) => group.mice).length, 'mouse', 'mice')}, ${counted(raced.length, 'maze')}`;
      page.hold(results, raced, `The race is over: ${entries}.`, order);
    } catch (error) {
      page.complain(error);
    } finally {
      begin.disabled = false;
      running.hidden = true;
    }
  }
  function chosen(): Order {
    const { world: where, settings } = world.chosen();
    return {
      mice: mice.chosen(),
      mazes: mazes.chosen().map((name) => own.get(name) ?? name),
      runs: runs.read(),
      seed: seed.read(),
      ...(!where.home && { world: { ...settings, world: where.name } }),
    };
  }
  /** A maze of a link is one of the user's from now on, unless it is that already. */
  function take(maze: MazeData): string {
    for (const [name, mine] of own) if (isSameMaze({ maze: mine }, { maze })) return name;
    linked.push(maze);
    refresh();
    return take(maze);
  }
  function set(order: Order) {
    world.choose(order.world?.world, order.world);
    enter();
    const names = order.mazes.map((maze) => (typeof maze === 'string' ? maze : take(maze)));
    mazes.choose(names);
    mice.choose(order.mice);
    runs.write(order.runs);
    seed.write(order.seed);
  }
  function start() {
    const order = chosen();
    if (order.mice.length === 0 || order.mazes.length === 0)
      return page.complain('Choose at least one mouse and one maze.');
    void hold(order);
  }
  const submit = (event: Event) => (event.preventDefault(), start());
  const element = h(
    'form',
    { class: 'hold', onsubmit: submit },
    world.element,
    h('div', { class: 'sides' }, mice.element, mazes.element),
    h('div', { class: 'row' }, runs.element, seed.element, begin),
    running,
  );
  return { element, refresh, order: chosen, set, start };
}
