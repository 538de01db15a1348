// How a part of the robot is given, as limits or as published times, and a switch between the two.
import { useRef } from 'preact/hooks';
import type { Page } from '../page/page';
import { Select } from '../ui/controls';
import { Field } from '../ui/field';
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

interface Props {
  page: Page;
  draft: Draft;
  form: RobotForm;
  /** Hears of a change of the form. */
  changed(): void;
}

const words: Record<Part, [label: string, help: string]> = {
  turns: ['Turns are given', 'limits of its curves, or one speed and the time of each turn'],
  search: ['The search is given', 'a speed and its pivots, or the time of each move'],
};

function PartSwitch({ part, page, draft, form, changed }: Props & { part: Part }) {
  const { robot_keys: keys } = page.about;
  const [label, help] = words[part];
  /** The limits that the last change took away. */
  const limits = useRef<Values | null>(null);
  async function change(way: string) {
    const values = form.values();
    if (way === 'times') limits.current = values;
    if (way === 'times' && !draft.result) return;
    const next =
      way === 'times'
        ? withTimes(values, keys, part, draft.result!)
        : withLimits(values, keys, part, limits.current ?? (await limitsOf(page, part, values.cell)));
    form.show(next, keysBeside(next, keys));
    changed();
  }
  return (
    <Field label={label} help={help}>
      <Select
        options={[
          ['limits', 'as limits'],
          ['times', 'as published times'],
        ]}
        value={hasTimes(form.values(), keys, part) ? 'times' : 'limits'}
        choose={(way) => void change(way).catch(page.complain)}
      />
    </Field>
  );
}

/** What a change took away is not of another robot: give it a key for each. */
export const PartSwitches = (props: Props) => (
  <>
    <PartSwitch part="turns" {...props} />
    <PartSwitch part="search" {...props} />
  </>
);
