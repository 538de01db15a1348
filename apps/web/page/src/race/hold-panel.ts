// The form that holds a race in the page.
import type { About, MazeData } from '../core/types';
import { isSameMaze } from '../maze/same';
import { h } from '../ui/dom';
import { createWorldChoice } from '../live/world-choice';
import type { EarlyPage } from '../views/view';
import { groupsOf } from './contests';
import { counted } from './format';
import { holdRace, type Order } from './holding';

export const usual = ['ariadne', 'flood-return', 'certify', 'flood', 'frontier'];
/** So many are named while the list is folded. */
const mostNamed = 6;

export interface Choice {
  name: string;
  about: string;
  on: boolean;
}

export interface Picks {
  element: HTMLElement;
  chosen(): string[];
  /** Chooses those and no others; of what is not offered it says so. */
  choose(names: string[]): void;
  /** Offers other things; what was chosen among those that stay is kept. */
  offer(choices: Choice[]): void;
}

/** A list that is folded away. */
export function picks(title: string, choices: Choice[]): Picks {
  const on = new Map<string, HTMLInputElement>();
  const list = h('div', { class: 'list' });
  const boxes = () => [...on.values()];
  const summary = h('summary', {});
  const chosen = () => boxes().flatMap((box) => (box.checked ? [box.value] : []));
  function count() {
    const names = chosen();
    const few = names.length > 0 && names.length <= mostNamed ? `: ${names.join(', ')}` : '';
    summary.replaceChildren(`${title}, ${names.length} of ${on.size}${few}`);
  }
  function setAll(checked: boolean) {
    boxes().forEach((box) => (box.checked = checked));
    count();
  }
  function offer(now: Choice[]) {
    const before = new Map(on);
    on.clear();
    for (const { name, on: checked } of now)
      on.set(name, before.get(name) ?? h('input', { type: 'checkbox', value: name, checked }));
    list.replaceChildren(...now.map(({ name, about }) => h('label', { title: about }, on.get(name)!, name)));
    count();
  }
  offer(choices);
  return {
    element: h(
      'details',
      { class: 'picks' },
      summary,
      h(
        'fieldset',
        { 'aria-label': title, onchange: count },
        h(
          'p',
          { class: 'row' },
          h('button', { type: 'button', onclick: () => setAll(true) }, 'All'),
          h('button', { type: 'button', onclick: () => setAll(false) }, 'None'),
        ),
        list,
      ),
    ),
    chosen,
    choose(names) {
      const missing = names.find((name) => !on.has(name));
      if (missing !== undefined) throw new Error(`This link cannot be followed: there is no '${missing}' here.`);
      for (const [name, box] of on) box.checked = names.includes(name);
      count();
    },
    offer,
  };
}

/** Each under a name of its own, which is how results tell mazes apart. */
export function namedApart(mazes: MazeData[], taken: string[]): MazeData[] {
  const names = new Set(taken);
  return mazes.map((maze) => {
    const first = maze.name || 'drawing';
    let name = first;
    for (let count = 2; names.has(name); ++count) name = `${first}-${count}`;
    names.add(name);
    return { ...maze, name };
  });
}

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
