// The numbers of a robot as a form, built from the keys that the core lists.
import type { RobotKey, RobotSentence, RobotValue } from '../core/types';
import { h } from '../ui/dom';
import { field } from '../ui/field';

export type Values = Record<string, RobotValue>;

export type RobotForm = ReturnType<typeof createRobotForm>;

const titles: Record<string, string> = {
  '': 'Robot',
  straight: 'Straights',
  diagonal: 'Diagonals',
  curve: 'Curves',
  layout: 'Published paths of turns',
  turns: 'Published times of turns',
  search: 'Search',
};

const sectionOf = (key: string) => (key.includes('.') ? key.split('.', 1)[0] : '');
const shortOf = (key: string) => key.slice(key.indexOf('.') + 1).replaceAll('_', ' ');

type Row = ReturnType<typeof createRow>;

function numberRow(key: RobotKey, value: RobotValue | undefined, input: () => void) {
  const control = h('input', {
    type: 'number',
    inputmode: 'decimal',
    step: key.kind === 'whole' ? 1 : 'any',
    min: key.low,
    max: key.high,
    value: typeof value === 'number' ? value : '',
    placeholder: key.needed ? '' : 'default',
    required: key.needed,
    oninput: input,
  });
  const never = h('input', {
    type: 'checkbox',
    checked: value === false,
    onchange: () => {
      control.disabled = never.checked;
      input();
    },
  });
  control.disabled = value === false;
  const read = (): RobotValue | undefined => {
    if (key.kind === 'number_or_false' && never.checked) return false;
    if (control.validity.badInput) return 'no number';
    return control.value === '' ? undefined : control.valueAsNumber;
  };
  const beside = key.kind === 'number_or_false' && h('label.check', never, `${key.name} is not driven`);
  return { control, beside, read };
}

function choiceRow(key: RobotKey, value: RobotValue | undefined, input: () => void) {
  const isText = key.kind === 'choice';
  const options = isText ? key.choices : ['true', 'false'];
  const control = h(
    'select',
    { onchange: input },
    h('option', { value: '' }, 'default'),
    ...options.map((one) => h('option', { value: one, selected: String(value) === one }, one)),
  );
  const read = () => (control.value === '' ? undefined : isText ? control.value : control.value === 'true');
  return { control, beside: false as const, read };
}

function createRow(key: RobotKey, value: RobotValue | undefined, changed: () => void) {
  const isChoice = key.kind === 'yes_or_no' || key.kind === 'choice';
  const { control, beside, read } = (isChoice ? choiceRow : numberRow)(key, value, changed);
  const unit = key.unit && ` (${key.unit})`;
  const help = h('span', key.meaning, h('span.range', ` ${key.range}`));
  const element = field(`${shortOf(key.name)}${unit}`, control, help);
  control.dataset.key = key.name;
  const remark = h('span.field-remark', { role: 'status' });
  element.append(...(beside ? [beside] : []), remark);
  return {
    element,
    remark,
    /** Undefined where nothing is given; a text where the browser can make no number of it. */
    read,
  };
}

/** `changed` hears of every edit; `again` where other keys have a meaning after it. */
export function createRobotForm(keys: RobotKey[], changed: () => void) {
  const element = h('div.robot-form');
  const rows = new Map<string, Row>();
  let lists: Values = {};
  let shown = '';

  function rowOf(key: RobotKey, value: RobotValue | undefined): HTMLElement {
    const row = createRow(key, value, changed);
    rows.set(key.name, row);
    return row.element;
  }
  function sectionElement(section: string, of: RobotKey[], values: Values) {
    const title = titles[section] ?? section;
    const fields = of.map((key) => rowOf(key, values[key.name]));
    const isGiven = section !== 'layout' || of.some(({ name }) => name in values);
    return h(
      'details.card',
      { open: isGiven, 'data-section': section },
      h('summary', h('h2', title)),
      h('div.parameters', ...fields),
    );
  }
  return {
    element,
    /** The values of another robot; the keys are those that have a meaning beside them. */
    show(values: Values, wanted: string[]) {
      const now = JSON.stringify([values, wanted]);
      if (now === shown) return;
      shown = now;
      rows.clear();
      // Lists of sensors have no fields; they stay as they are.
      lists = Object.fromEntries(Object.entries(values).filter(([, value]) => Array.isArray(value)));
      const of = keys.filter(({ name }) => wanted.includes(name));
      const sections = [...new Set(of.map(({ name }) => sectionOf(name)))];
      const within = (section: string) => of.filter(({ name }) => sectionOf(name) === section);
      element.replaceChildren(...sections.map((section) => sectionElement(section, within(section), values)));
    },
    values() {
      const values: Values = { ...lists };
      for (const [name, { read }] of rows) {
        const value = read();
        if (value !== undefined) values[name] = value;
      }
      shown = '';
      return values;
    },
    /** Says each sentence at its field; gives back those without one. */
    say(problems: RobotSentence[], remarks: RobotSentence[]) {
      for (const [name, { element: row, remark }] of rows) {
        const mine = ({ key }: RobotSentence) => key === name;
        row.complain(problems.find(mine)?.text ?? '');
        const words = remarks.find(mine)?.text ?? '';
        if (remark.textContent !== words) remark.replaceChildren(words);
      }
      return [...problems, ...remarks].filter(({ key }) => !rows.has(key));
    },
  };
}
