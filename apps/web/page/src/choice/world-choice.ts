// In which world mice run, and what is set of it: all that the core has, each with its settings.
import type { About, Parameter, WorldInPage } from '../core/types';
import { drivingWorld } from '../link/contest';
import { isMine, myRobot, nameOf, onMyRobot, setMyRobot } from '../link/my-robot';
import type { Settings } from '../results/holding';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import { controlOf, read } from './parameters';

interface Row {
  element: HTMLElement;
  read(): string | number | boolean;
  write(value: string | number | boolean): void;
}

/** The name of a setting for people. */
const capital = (name: string) => name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ');

/** Text of a control, of a default or of a link as the core takes a value of that type. */
export function typed(text: string | null, { type, default: usual }: Parameter): Settings[string] {
  if (type === 'flag') return text === 'yes' || text === 'true';
  return type === 'whole' ? Number(text || usual) : (text ?? usual);
}

/** A setting that is typed or ticked. */
function plainRow(setting: Parameter, changed: () => void): Row {
  const [control, ...beside] = controlOf(setting, setting.default);
  control.addEventListener('input', changed);
  const element = field(capital(setting.name), control, h('span', setting.meaning));
  element.append(...beside);
  return {
    element,
    read: () => typed(read(control), setting),
    write(value) {
      if (control instanceof HTMLInputElement && control.type === 'checkbox') control.checked = value === true;
      else control.value = String(value);
    },
  };
}

/** A setting that is one of several; `words` of each, and a line that follows from the chosen one. */
function listRow(setting: Parameter, changed: () => void, words = (name: string) => name, help?: HTMLElement) {
  const select = h(
    'select',
    { onchange: changed },
    ...(setting.choices ?? []).map((name) => h('option', { value: name }, words(name))),
  );
  select.value = setting.default;
  const row: Row = {
    element: field(capital(setting.name), select, help ?? h('span', setting.meaning)),
    read: () => select.value,
    write(value) {
      if ([...select.options].some((option) => option.value === value)) select.value = String(value);
    },
  };
  return { ...row, select };
}

/** Among the robots is that of the view Robot, where there is one. */
function robotRow(setting: Parameter, { robots }: About, changed: () => void): Row {
  const cells = (name: string) => `${name}, cells of ${robots.find((one) => one.name === name)?.cell} mm`;
  const { select, ...row } = listRow(setting, changed, cells, h('a', { href: '#robot' }, 'Change its numbers'));
  const own = h('option', { hidden: true });
  select.append(own);
  function offerMine() {
    const mine = myRobot();
    const chosen = select.value === own.value && !own.hidden;
    if (mine === null && chosen) select.value = robots[0].name;
    own.hidden = mine === null;
    own.disabled = mine === null;
    own.value = mine ?? '';
    own.textContent = mine === null ? '' : `${nameOf(mine)}, my robot`;
    if (mine !== null && chosen) select.value = mine;
    if (chosen) changed();
  }
  onMyRobot(offerMine);
  offerMine();
  return {
    ...row,
    write(value) {
      if (isMine(String(value))) setMyRobot(String(value));
      row.write(value);
    },
  };
}

function rulesRow(setting: Parameter, { drive_rules: all }: About, changed: () => void): Row {
  const source = h('span');
  const show = () => (source.textContent = all.find(({ name }) => name === select.value)?.source ?? '');
  const words = (name: string) =>
    setting.by_size && name === setting.default ? setting.by_size.join(', in half-size mazes ') : name;
  const { select, ...row } = listRow(setting, () => (show(), changed()), words, source);
  show();
  return { ...row, write: (value) => (row.write(value), show()) };
}

function rowOf(setting: Parameter, about: About, changed: () => void): Row {
  if (setting.name === 'robot') return robotRow(setting, about, changed);
  if (setting.name === 'rules') return rulesRow(setting, about, changed);
  return setting.choices ? listRow(setting, changed) : plainRow(setting, changed);
}

/** `worlds` are offered. */
export function createWorldChoice(about: About, changed: () => void, worlds = about.worlds) {
  const select = h(
    'select',
    { onchange: () => (update(), changed()) },
    ...worlds.map((one) => h('option', { value: one.name }, `${one.name}: ${one.summary}`)),
  );
  const [first] = worlds;
  const world = () => worlds.find(({ name }) => name === select.value) ?? first;
  const soon = (of: WorldInPage) => () => of === world() && changed();
  const rows = new Map(
    worlds.map((one) => [
      one.name,
      new Map(one === first ? [] : one.settings.map((setting) => [setting.name, rowOf(setting, about, soon(one))])),
    ]),
  );
  const note = h('span');
  const element = h(
    'div.world-choice',
    { hidden: worlds.length < 2 },
    field('World', select, note),
    ...[...rows.values()].flatMap((list) => [...list.values()].map((row) => row.element)),
  );
  function update() {
    const { name, mice } = world();
    for (const [one, list] of rows) for (const row of list.values()) row.element.hidden = one !== name;
    note.textContent = mice.length < first.mice.length ? `mice that run there: ${mice.join(', ')}` : '';
  }
  function chosen() {
    const list = [...rows.get(world().name)!].map(([name, row]) => [name, row.read()]);
    return { world: world(), settings: Object.fromEntries(list) as Settings };
  }
  select.value = first.name;
  update();
  return {
    element,
    /** The world, and what is set of it: nothing of the first one, whose settings are the view's own. */
    chosen,
    /** What a contest that is driven needs; null in worlds where nothing is. */
    drive() {
      const { world, settings } = chosen();
      if (world !== drivingWorld(about)) return null;
      return { world: world.name, robot: String(settings.robot), rules: String(settings.rules) };
    },
    /** Chooses that world, or the first one where there is no name. A setting that is none stays as it was. */
    choose(name: string = first.name, settings: Settings = {}) {
      select.value = name;
      for (const [key, value] of Object.entries(settings)) rows.get(name)?.get(key)?.write(value);
      update();
    },
  };
}
