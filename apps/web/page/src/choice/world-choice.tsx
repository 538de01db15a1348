// In which world mice run, and what is set of it: all that the core has, each with its settings.
import { useEffect, useReducer } from 'preact/hooks';
import type { About, Parameter, WorldInPage } from '../core/types';
import { drivingWorld } from '../link/contest';
import { isMine, myRobot, nameOf, onMyRobot, setMyRobot } from '../link/my-robot';
import type { Settings } from '../results/holding';
import { Select } from '../ui/controls';
import { Field } from '../ui/field';
import { Control } from './parameters';

export type WorldChoice = ReturnType<typeof createWorldChoice>;

/** What is typed or chosen of a world, as text; null where the browser can make nothing of it. */
type Texts = Record<string, string | null>;

/** The name of a setting for people. */
const capital = (name: string) => name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ');

/** Text of a control, of a default or of a link as the core takes a value of that type. */
export function typed(text: string | null, { type, default: usual }: Parameter): Settings[string] {
  if (type === 'flag') return text === 'yes' || text === 'true';
  return type === 'whole' ? Number(text || usual) : (text ?? usual);
}

const usualTexts = ({ settings }: WorldInPage): Texts =>
  Object.fromEntries(settings.map(({ name, default: usual }) => [name, usual]));

/** Whether that text can be chosen; among the robots is that of the view Robot, where there is one. */
const mayBe = ({ name, choices }: Parameter, text: string) =>
  !choices || choices.includes(text) || (name === 'robot' && text === myRobot());

/** `worlds` are offered; `changed` hears of what is chosen in the form, and where the user's robot is another one. */
export function createWorldChoice(about: About, changed: () => void, worlds = about.worlds) {
  const [first] = worlds;
  const texts = new Map(worlds.map((one) => [one, usualTexts(one)]));
  let world = first;
  let mine = myRobot();
  onMyRobot(() => {
    const before = mine;
    mine = myRobot();
    const isChosen = before !== null && texts.get(world)!.robot === before;
    for (const of of texts.values())
      if (before !== null && of.robot === before) of.robot = mine ?? about.robots[0].name;
    if (isChosen && world !== first) changed();
  });
  /** The world, and what is set of it: nothing of the first one, whose settings are the view's own. */
  function chosen() {
    const own = world === first ? [] : world.settings;
    const list = own.map((setting) => [setting.name, typed(texts.get(world)![setting.name], setting)]);
    return { world, settings: Object.fromEntries(list) as Settings };
  }
  const named = (name: string) => worlds.find((one) => one.name === name) ?? first;
  return {
    about,
    worlds,
    chosen,
    texts: () => texts.get(world)!,
    pick(name: string) {
      world = named(name);
      changed();
    },
    set(setting: string, text: string | null) {
      texts.get(world)![setting] = text;
      changed();
    },
    /** What a contest that is driven needs; null in worlds where nothing is. */
    drive() {
      const { world, settings } = chosen();
      if (world !== drivingWorld(about)) return null;
      return { world: world.name, robot: String(settings.robot), rules: String(settings.rules) };
    },
    /** Chooses that world, or the first one where there is no name. A setting that is none stays as it was. */
    choose(name: string = first.name, settings: Settings = {}) {
      world = named(name);
      for (const setting of world.settings) {
        if (!(setting.name in settings)) continue;
        const text = String(settings[setting.name]);
        if (setting.name === 'robot' && isMine(text)) setMyRobot(text);
        if (mayBe(setting, text)) texts.get(world)![setting.name] = text;
      }
    },
  };
}

/** The options of a setting that is one of several, and a line that follows from the chosen one. */
function optionsOf(setting: Parameter, about: About, chosen: string) {
  const { name, choices = [], meaning } = setting;
  const mine = myRobot();
  if (name === 'robot') {
    const cellOf = (robot: string) => about.robots.find((one) => one.name === robot)?.cell;
    const built = choices.map((one) => [one, `${one}, cells of ${cellOf(one)} mm`]);
    const own: [string, string][] = mine === null ? [] : [[mine, `${nameOf(mine)}, my robot`]];
    return { options: [...built, ...own], help: <a href="#robot">Change its numbers</a> };
  }
  if (name === 'rules') {
    const words = (one: string) =>
      setting.by_size && one === setting.default ? setting.by_size.join(', in half-size mazes ') : one;
    const source = about.drive_rules.find((one) => one.name === chosen)?.source ?? '';
    return { options: choices.map((one) => [one, words(one)]), help: source };
  }
  return { options: choices, help: meaning };
}

/** A setting of the chosen world. */
function SettingField({ setting, choice: { about, texts, set } }: { setting: Parameter; choice: WorldChoice }) {
  const { name, choices, meaning } = setting;
  const text = texts()[name] ?? '';
  if (!choices)
    return (
      <Field label={capital(name)} help={meaning}>
        <Control parameter={setting} value={text} change={(next, isValid) => set(name, isValid ? next : null)} />
      </Field>
    );
  const { options, help } = optionsOf(setting, about, text);
  return (
    <Field label={capital(name)} help={help}>
      <Select options={options} value={text} choose={(next) => set(name, next)} />
    </Field>
  );
}

export function WorldFields({ choice }: { choice: WorldChoice }) {
  const { worlds, chosen, pick } = choice;
  const [, draw] = useReducer((count: number) => count + 1, 0);
  useEffect(() => onMyRobot(() => draw(0)), []);
  const { world } = chosen();
  const note = world.mice.length < worlds[0].mice.length ? `mice that run there: ${world.mice.join(', ')}` : '';
  const options = worlds.map(({ name, summary }) => [name, `${name}: ${summary}`]);
  return (
    <div class="world-choice" hidden={worlds.length < 2}>
      <Field label="World" help={note}>
        <Select options={options} value={world.name} choose={pick} />
      </Field>
      {world !== worlds[0] &&
        world.settings.map((setting) => (
          <SettingField key={`${world.name} ${setting.name}`} setting={setting} choice={choice} />
        ))}
    </div>
  );
}
