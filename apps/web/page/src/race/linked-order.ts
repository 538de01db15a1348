// A race in a link: what is asked for, and nothing of what comes of it.
import type { Core } from '../core/client';
import type { About } from '../core/types';
import type { Moment } from '../link/address';
import { driveOf } from '../link/contest';
import { placesOf } from '../link/mazes';
import type { Order } from './holding';

/** Contests that take a second or two on any machine. */
const quick = { home: 150, others: 12 };

/** How many contests there are: mice that throw no dice run once in each maze. */
function contestsOf(about: About, { mice, mazes, runs }: Order): number {
  const throwing = (mouse: string) => about.mice.find(({ name }) => name === mouse)?.throws_dice ?? true;
  return mice.reduce((sum, mouse) => sum + (throwing(mouse) ? runs : 1), 0) * mazes.length;
}

/** Whether a race may begin without a click. */
export const isQuick = (about: About, order: Order): boolean =>
  contestsOf(about, order) <= (order.world ? quick.others : quick.home);

/** What a link says of a world besides the home world: those that are driven can be told in one. */
function drivenIn({ world, robot, rules }: NonNullable<Order['world']>): Pick<Moment, 'robot' | 'rules'> {
  if (typeof robot === 'string' && typeof rules === 'string') return { robot, rules };
  throw new Error(`A link holds no races in the world ${world}. Send the results instead.`);
}

export async function orderMoment(core: Core, about: About, order: Order): Promise<Partial<Moment>> {
  const { mice, mazes, runs, seed, world } = order;
  const drive = world && drivenIn(world);
  return { mice, ...(await placesOf(core, about, mazes)), seeds: [seed], runs, ...drive };
}

/** What a link asks for; throws in words where that is no race. */
export async function orderIn(core: Core, about: About, moment: Moment): Promise<Order> {
  const { mice, builtin, mazes, seeds, runs = 1, robot, rules } = moment;
  if (mice.length === 0 || builtin.length + mazes.length === 0)
    throw new Error('This link cannot be followed: a race needs at least one mouse and one maze.');
  if (seeds.length > 1) throw new Error('This link cannot be followed: a race has one seed.');
  const named = builtin.join() === 'all' ? about.mazes.map(({ name }) => name) : builtin;
  const linked = await Promise.all(mazes.map(async (link) => (await core.call('read_link', { link })).maze));
  const drive = driveOf({ robot, rules }, about);
  return {
    mice: [...new Set(mice)],
    mazes: [...new Set(named), ...linked],
    runs,
    seed: seeds[0] ?? 1,
    ...(drive && { world: { ...drive.with, world: drive.world } }),
  };
}
