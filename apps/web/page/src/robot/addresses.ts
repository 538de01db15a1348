// The robot in links, and in what the browser keeps until the page is opened again.
import { addressOf, readAddress, type Moment } from '../link/address';
import { driveOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import { myRobot, withoutRemarks, type KeptRobot, type Origin } from '../link/my-robot';
import type { MazeData } from '../core/types';
import type { MazeChoice } from '../choice/maze-choice';
import type { Page } from '../page/page';
import { originOf, type Draft } from './draft';
import type { RobotForm } from './form';
import type { Question as Varied } from './regions';

/** The parts of the view that a link or a kept robot sets. */
export interface RobotDesk {
  page: Page;
  draft: Draft;
  form: RobotForm;
  mazes: MazeChoice;
  begin(from: Origin): void;
  /** Asks the core about the robot in the form. */
  ask(): void;
}

/** The text behind `#` that leads to the robot, its maze and the regions that are `asked` for. */
export async function robotAddress(page: Page, { refused, given, origin, maze }: Draft, asked: Varied) {
  if (refused) throw new Error('A link cannot hold this robot, for it is refused: mend its numbers first.');
  const robot = given ?? (origin.text === null ? origin.name : `${origin.name}\n${origin.text}`);
  const place = maze && (await placeOf(page.core, page.about, maze));
  return addressOf('robot', { ...place, robot: withoutRemarks(robot), ...asked });
}

/** Keeps an edited robot with what it began from, and what is asked of it in which maze. */
export async function keepRobot(page: Page, { linked, refused, maze, given, origin }: Draft, asked: Varied) {
  if (linked || refused || !maze) return;
  await page.shelf.write('robot', given && { ...originOf(given), origin });
  const robot = given === null && origin.text === null ? { robot: origin.name } : {};
  const place = await placeOf(page.core, page.about, maze);
  await page.shelf.write('robot-at', `#${addressOf('robot', { ...place, ...robot, ...asked })}`);
}

/** To that maze, if any, and the regions that are asked for there. */
function goTo({ draft, mazes }: RobotDesk, moment: Moment, maze: MazeData | null) {
  draft.wanted = moment.vary ? { varied: { vary: moment.vary, and: moment.and }, maze } : null;
  if (maze && moment.builtin.length > 0) mazes.choose(moment.builtin[0]);
  else if (maze) mazes.give(maze);
}

export async function followRobot(desk: RobotDesk, hash: string) {
  const { core, about } = desk.page;
  const { moment } = readAddress(hash);
  if (moment.and && !moment.vary)
    throw new Error('This link cannot be followed: it varies a second number and no first one.');
  const robot = moment.robot && driveOf({ robot: moment.robot }, about)?.robot;
  const maze = await mazeAt(core, moment);
  if (robot) desk.begin(originOf(robot));
  desk.draft.linked = true;
  goTo(desk, moment, maze);
}

/** A robot that was edited before the page was opened again, with what it began from, and where it was. */
export async function reopenRobot(desk: RobotDesk, { name, text, origin = { name, text }, at }: KeptRobot) {
  const { core } = desk.page;
  desk.begin(origin);
  desk.draft.name = name;
  const { values, keys } = await core.call('robot', { name }, new TextEncoder().encode(text));
  // Somebody was quicker, and began with another robot or edited this one.
  if (desk.draft.origin !== origin || !desk.draft.fresh) return;
  desk.form.show(values, keys);
  Object.assign(desk.draft, { keys, fresh: false, given: myRobot() });
  desk.ask();
  if (!at) return;
  const { moment } = readAddress(at);
  goTo(desk, moment, await mazeAt(core, moment));
}
