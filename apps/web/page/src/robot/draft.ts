// The robot that is edited: what it began from, and what the core has answered about it.
import type { About, MazeData, RobotResult } from '../core/types';
import { isMine, nameOf, type Origin } from '../link/my-robot';
import type { Values } from './form';
import type { Question as Varied } from './regions';

export interface Draft {
  origin: Origin;
  /** As it was typed. */
  name: string;
  /** Nothing was edited since it began. */
  fresh: boolean;
  /** The keys that the form shows. */
  keys: string[];
  maze: MazeData | null;
  values: Values;
  /** Its file. */
  text: string;
  /** Whether the last robot that was asked for can be none. */
  refused: boolean;
  /** What followed from the last robot that could be. */
  result: RobotResult | null;
  /** What the view gave to the others last. */
  given: string | null;
  /** Whether it stands as it came with a link: then that of this browser is kept. */
  linked: boolean;
  /** Which regions a link asks for, and in which maze (null: in any), until that is shown. */
  wanted: { varied: Varied; maze: MazeData | null } | null;
  isShown: boolean;
}

export function createDraft({ robots }: About): Draft {
  const usual = robots.find(({ name }) => name === 'classic') ?? robots[0];
  return {
    origin: { name: usual?.name ?? '', text: null },
    name: 'my-mouse',
    fresh: true,
    keys: [],
    maze: null,
    values: {},
    text: '',
    refused: false,
    result: null,
    given: null,
    linked: false,
    wanted: null,
    isShown: false,
  };
}

/** What a robot is that came as its name, or with its file in the lines below. */
export const originOf = (robot: string): Origin => ({
  name: nameOf(robot),
  text: isMine(robot) ? robot.slice(nameOf(robot).length + 1) : null,
});

/** What the address leads to is no longer what is shown. */
export function leaveLink(draft: Draft) {
  if (draft.linked && draft.isShown) history.replaceState(null, '', '#robot');
  draft.linked = false;
}

/** What it is called, in one line. */
export const calledOf = ({ name }: Draft) => name.trim().replaceAll('\n', ' ') || 'robot';
