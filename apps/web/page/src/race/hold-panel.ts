// The form that runs a race in the page.
import type { About, MazeData } from '../core/types';
import { isSameMaze } from '../maze/same';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import { createWorldChoice } from '../choice/world-choice';
import type { EarlyPage } from '../page/page';
import { mazePicks, picks, usual } from '../choice/picks';
import { groupsOf } from '../results/contests';
import { counted } from '../ui/format';
import { holdRace, type Order, type Progress } from '../results/holding';

const whole = (label: string | Node, value: number, most: number) => {
  const input = h('input', { type: 'number', min: 1, max: most, step: 1, value, required: true });
  const read = () => Math.max(1, Math.min(most, Math.round(input.valueAsNumber) || value));
  return {
    element: h('label.row', label, input),
    read,
    write: (now: number) => (input.value = String(now)),
  };
};

/** Holds races, and shows how far they are; `begin` is the button that begins one. */
function createRunning(page: EarlyPage, begin: HTMLButtonElement) {
  const bar = h('progress', { max: 1, value: 0, 'aria-label': 'Progress of the race' });
  const doing = h('span.note');
  let wanted = true;
  function stop() {
    wanted = false;
    page.core.stop('race');
  }
  const element = h('div.row', { hidden: true }, bar, doing, button('Stop', stop));
  function report(now: Progress) {
    bar.max = now.all;
    bar.value = now.done;
    doing.textContent = `${now.doing}, mouse ${now.done + 1} of ${now.all}`;
  }
  async function hold(order: Order) {
    wanted = true;
    begin.disabled = true;
    element.hidden = false;
    try {
      const held = await holdRace(page.core, order, report, () => wanted);
      if (!held) return page.tell('The race was stopped.');
      const { results, mazes } = held;
      const mice = groupsOf(results).flatMap((group) => group.mice);
      const entries = `${counted(mice.length, 'mouse', 'mice')}, ${counted(mazes.length, 'maze')}`;
      page.hold(results, mazes, `The race is over: ${entries}.`, order);
    } catch (error) {
      page.complain(error);
    } finally {
      begin.disabled = false;
      element.hidden = true;
    }
  }
  return { element, hold };
}

/** Who races, where, how often: an order, to be read and to be set. */
function createOrderForm(page: EarlyPage, about: About) {
  const world = createWorldChoice(about, enter);
  let { world: where } = world.chosen();
  const entrants = () =>
    about.mice
      .filter(({ name }) => where.mice.includes(name))
      .map(({ name, summary }) => ({ name, about: summary, on: usual.includes(name) }));
  const mice = picks('Mice', entrants());
  /** Those that came with links. */
  const linked: MazeData[] = [];
  const mazes = mazePicks('Mazes', about, () => [...page.mazes(), ...linked], false);
  const whose = h('span');
  const runs = whole(whose, where.usual_runs, 100);
  const seed = whole('seed', 1, 2 ** 53 - 1);
  /** Offers what there is in the chosen world: its mice, and as many runs as are usual there, unless others were chosen. */
  function enter() {
    const { usual_runs: before } = where;
    where = world.chosen().world;
    if (runs.read() === before) runs.write(where.usual_runs);
    whose.textContent = where.is_stochastic ? 'runs of each mouse' : 'runs of stochastic mice';
    mice.offer(entrants());
  }
  enter();
  /** A maze of a link is one of the user's from now on, unless it is that already. */
  function take(maze: MazeData): string {
    for (const [name, mine] of mazes.own()) if (isSameMaze({ maze: mine }, { maze })) return name;
    linked.push(maze);
    mazes.refresh();
    return take(maze);
  }
  function read(): Order {
    const { world: where, settings } = world.chosen();
    const asked = { mice: mice.chosen(), mazes: mazes.chosenMazes(), runs: runs.read(), seed: seed.read() };
    return { ...asked, ...(where !== about.worlds[0] && { world: { ...settings, world: where.name } }) };
  }
  function set(order: Order) {
    world.choose(order.world?.world, order.world);
    enter();
    mazes.choose(order.mazes.map((maze) => (typeof maze === 'string' ? maze : take(maze))));
    mice.choose(order.mice);
    runs.write(order.runs);
    seed.write(order.seed);
  }
  const lists = h('div.sides', mice.element, mazes.element);
  return { elements: [world.element, lists], numbers: [runs.element, seed.element], refresh: mazes.refresh, read, set };
}

/** The form, once it is known what the core brings. */
export function holdPanel(page: EarlyPage, about: About) {
  const form = createOrderForm(page, about);
  const begin = h('button.main', { type: 'submit' }, 'Start the race');
  const running = createRunning(page, begin);
  function start() {
    const order = form.read();
    if (order.mice.length === 0 || order.mazes.length === 0)
      return page.complain('Choose at least one mouse and one maze.');
    void running.hold(order);
  }
  const element = h(
    'form.hold',
    { onsubmit: (event: Event) => (event.preventDefault(), start()) },
    ...form.elements,
    h('div.row', ...form.numbers, begin),
    running.element,
  );
  return {
    element,
    /** Offers the mazes that there are by now. */
    refresh: form.refresh,
    /** What is chosen. */
    order: form.read,
    /** Chooses that. */
    set: form.set,
    /** Runs the race that is chosen. */
    start,
  };
}
