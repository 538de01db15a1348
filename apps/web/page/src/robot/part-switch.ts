// How a part of the robot is given, as limits or as published times, and a switch between the two.
import type { Page } from '../page/page';
import { select } from '../ui/controls';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import type { Draft } from './draft';
import type { RobotForm, Values } from './form';
import { hasTimes, keysBeside, withLimits, withTimes, type Part } from './forms';

/** Limits of a robot that has them, with cells of that size where there is one. */
async function limitsOf({ core, about: { robots, robot_keys: keys } }: Page, part: Part, cell: unknown) {
  const others = [...robots].sort((a, b) => Number(b.cell === cell) - Number(a.cell === cell));
  for (const { name } of others) {
    const { values } = await core.call('robot', { name, built_in: name });
    if (!hasTimes(values, keys, part)) return values;
  }
  return {};
}

function partSwitch(
  page: Page,
  [part, label, help]: [Part, string, string],
  draft: Draft,
  form: RobotForm,
  changed: () => void,
) {
  const { robot_keys: keys } = page.about;
  const choice = select(
    [
      ['limits', 'as limits'],
      ['times', 'as published times'],
    ],
    (way) => void change(way).catch(page.complain),
  );
  /** The limits that the last change took away. */
  let limits: Values | null = null;
  async function change(way: string) {
    const values = form.values();
    if (way === 'times') limits = values;
    if (way === 'times' && !draft.result) return;
    const next =
      way === 'times'
        ? withTimes(values, keys, part, draft.result!)
        : withLimits(values, keys, part, limits ?? (await limitsOf(page, part, values.cell)));
    form.show(next, keysBeside(next, keys));
    changed();
  }
  return {
    element: field(label, choice, h('span', help)),
    show: (values: Values) => void (choice.value = hasTimes(values, keys, part) ? 'times' : 'limits'),
    /** What a change took away is not of another robot. */
    forget: () => void (limits = null),
  };
}

const parts: [Part, string, string][] = [
  ['turns', 'Turns are given', 'limits of its curves, or one speed and the time of each turn'],
  ['search', 'The search is given', 'a speed and its pivots, or the time of each move'],
];

export const partSwitches = (page: Page, draft: Draft, form: RobotForm, changed: () => void) =>
  parts.map((part) => partSwitch(page, part, draft, form, changed));
