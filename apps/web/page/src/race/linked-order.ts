// A race in a link: what is asked for, and nothing of what comes of it.
import type { Core } from '../core/client';
import type { About, Parameter, WorldInPage } from '../core/types';
import type { Moment } from '../link/address';
import { drivingWorld, driveOf } from '../link/contest';
import { placesOf } from '../link/mazes';
import { typed } from '../choice/world-choice';
import { isMine, withoutRemarks } from '../link/my-robot';
import { eachOf, type Order, type Settings } from '../results/holding';

/** Contests that take a second or two on any machine. */
const quick = { first: 150, others: 12 };

/** The number of contests in all its races; one in each maze if neither the mouse nor the world is stochastic. */
function contestsOf(about: About, { mice, mazes, runs, world }: Order): number {
  const dicey = about.worlds.find(({ name }) => name === world?.world)?.is_stochastic ?? false;
  const throwing = (mouse: string) => dicey || (about.mice.find(({ name }) => name === mouse)?.is_stochastic ?? true);
  const races = eachOf(world, about.worlds).length;
  return mice.reduce((sum, mouse) => sum + (throwing(mouse) ? runs : 1), 0) * mazes.length * races;
}

/** Whether a race may begin without a click. */
export const isQuick = (about: About, order: Order): boolean =>
  contestsOf(about, order) <= (order.world ? quick.others : quick.first);

type World = NonNullable<Order['world']>;

/** What a link says of a world: where the page drives contests, robot and rules as links of contests do. */
function worldMoment(about: About, { world, ...settings }: World): Partial<Moment> {
  const known = about.worlds.find(({ name }) => name === world);
  if (!known) throw new Error(`A link holds no races in the world ${world}. Send the results instead.`);
  const told = (name: string) => {
    const text = String(settings[name]);
    return isMine(text) ? withoutRemarks(text) : text;
  };
  if (known === drivingWorld(about)) return { robot: told('robot'), rules: told('rules') };
  const set = known.settings.filter(
    (one) => (settings[one.name] ?? typed(one.default, one)) !== typed(one.default, one),
  );
  return { world, set: set.map(({ name }) => `${name}=${told(name)}`) };
}

/** A setting as a link says it, as the core takes it; throws in words where the world has none such. */
function settingIn({ name: world, settings }: WorldInPage, text: string): [string, Settings[string]] {
  const [name] = text.split('=', 1);
  const told = text.slice(name.length + 1);
  const setting = settings.find((one) => one.name === name);
  if (!setting || !mayBe(told, setting))
    throw new Error(`This link cannot be followed: the world ${world} has no '${text.slice(0, 40)}'.`);
  return [name, typed(told, setting)];
}

/** Whether that text is a value of that setting; numbers with a point stand in texts, which the core reads. */
function mayBe(told: string, { name, type, choices }: Parameter): boolean {
  if (type === 'flag') return told === 'true' || told === 'false';
  if (type === 'whole') return /^\d{1,15}$/.test(told);
  return choices === undefined || choices.includes(told) || (name === 'robot' && isMine(told));
}

/** The world that a link names; undefined for the first one. */
function worldIn(about: About, { world, set = [], robot, rules }: Moment): Order['world'] {
  const drive = driveOf({ robot, rules }, about);
  if (world === undefined) {
    if (set.length > 0) throw new Error('This link cannot be followed: it says set= without world=.');
    return drive ?? undefined;
  }
  const known = about.worlds.slice(1).find(({ name }) => name === world);
  if (!known) throw new Error(`This link cannot be followed: this page knows no other world '${world.slice(0, 40)}'.`);
  if (drive) throw new Error('This link cannot be followed: next to world=, the robot and the rules stand in set=.');
  const usual = known.settings.map((setting) => [setting.name, typed(setting.default, setting)]);
  return { ...Object.fromEntries([...usual, ...set.map((text) => settingIn(known, text))]), world: known.name };
}

export async function orderMoment(core: Core, about: About, order: Order): Promise<Partial<Moment>> {
  const { mice, mazes, runs, seed, world } = order;
  return {
    mice,
    ...(await placesOf(core, about, mazes)),
    seeds: [seed],
    runs,
    ...(world && worldMoment(about, world)),
  };
}

/** What a link asks for; throws in words where that is no race. */
export async function orderIn(core: Core, about: About, moment: Moment): Promise<Order> {
  const { mice, builtin, mazes, seeds, runs = 1 } = moment;
  if (mice.length === 0 || builtin.length + mazes.length === 0)
    throw new Error('This link cannot be followed: a race needs at least one mouse and one maze.');
  if (seeds.length > 1) throw new Error('This link cannot be followed: a race has one seed.');
  const named = builtin.join() === 'all' ? about.mazes.map(({ name }) => name) : builtin;
  const linked = await Promise.all(mazes.map(async (link) => (await core.call('read_link', { link })).maze));
  const world = worldIn(about, moment);
  return {
    mice: [...new Set(mice)],
    mazes: [...new Set(named), ...linked],
    runs,
    seed: seeds[0] ?? 1,
    ...(world && { world }),
  };
}
