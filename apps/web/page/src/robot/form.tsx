// The numbers of a robot as a form, built from the keys that the core lists.
import type { RobotKey, RobotSentence, RobotValue } from '../core/types';
import { Check, NumberInput, numberOf, Select } from '../ui/controls';
import { Field } from '../ui/field';

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

/** What stands in a field. */
interface Entry {
  text: string;
  /** The browser can make a number of it. */
  isValid: boolean;
  /** It is ticked that this is not driven. */
  isOff: boolean;
}

const entryOf = (value: RobotValue | undefined): Entry => ({
  text: value === undefined ? '' : String(value),
  isValid: true,
  isOff: value === false,
});

const isChoice = ({ kind }: RobotKey) => kind === 'yes_or_no' || kind === 'choice';

/** Undefined where nothing is given; a text where the browser can make no number of it. */
function read(key: RobotKey, { text, isValid, isOff }: Entry): RobotValue | undefined {
  if (key.kind === 'number_or_false' && isOff) return false;
  if (!isValid) return 'no number';
  if (text === '') return undefined;
  if (key.kind === 'choice') return text;
  return isChoice(key) ? text === 'true' : numberOf(text);
}

/** `changed` hears of every edit. */
export function createRobotForm(keys: RobotKey[], changed: () => void) {
  const state = {
    /** Those that have a meaning beside the values. */
    keys: [] as RobotKey[],
    /** As they were given. */
    given: {} as Values,
    entries: new Map<string, Entry>(),
    problems: [] as RobotSentence[],
    remarks: [] as RobotSentence[],
  };
  return {
    state,
    set(name: string, changes: Partial<Entry>) {
      state.entries.set(name, { ...state.entries.get(name)!, ...changes });
      changed();
    },
    /** The values of another robot; the keys are those that have a meaning beside them. */
    show(given: Values, wanted: string[]) {
      const shown = keys.filter(({ name }) => wanted.includes(name));
      const entries = new Map(shown.map(({ name }) => [name, entryOf(given[name])]));
      Object.assign(state, { keys: shown, given, entries, problems: [], remarks: [] });
    },
    values() {
      // Lists of sensors have no fields; they stay as they are.
      const lists = Object.entries(state.given).filter(([, value]) => Array.isArray(value));
      const values: Values = Object.fromEntries(lists);
      for (const key of state.keys) {
        const value = read(key, state.entries.get(key.name)!);
        if (value !== undefined) values[key.name] = value;
      }
      return values;
    },
    /** Says each sentence at its field; gives back those without one. */
    say(problems: RobotSentence[], remarks: RobotSentence[]) {
      Object.assign(state, { problems, remarks });
      return [...problems, ...remarks].filter(({ key }) => !state.entries.has(key));
    },
  };
}

interface RowProps {
  form: RobotForm;
  of: RobotKey;
}

function Row({ form: { state, set }, of }: RowProps) {
  const { name, kind, unit, needed, choices } = of;
  const { text, isOff } = state.entries.get(name)!;
  const mine = ({ key }: RobotSentence) => key === name;
  const options: [string, string][] = (kind === 'choice' ? choices : ['true', 'false']).map((one) => [one, one]);
  const help = (
    <>
      {of.meaning}
      <span class="range"> {of.range}</span>
    </>
  );
  return (
    <Field label={`${shortOf(name)}${unit && ` (${unit})`}`} help={help} error={state.problems.find(mine)?.text ?? ''}>
      {isChoice(of) ? (
        <Select
          data-key={name}
          options={[['', 'default'], ...options]}
          value={text}
          choose={(text) => set(name, { text })}
        />
      ) : (
        <NumberInput
          data-key={name}
          inputMode="decimal"
          step={kind === 'whole' ? 1 : 'any'}
          min={of.low}
          max={of.high}
          placeholder={needed ? '' : 'default'}
          required={needed}
          disabled={isOff}
          value={isOff ? '' : text}
          change={(text, isValid) => set(name, { text, isValid })}
        />
      )}
      {kind === 'number_or_false' && (
        <Check label={`${name} is not driven`} checked={isOff} change={(isOff) => set(name, { isOff })} />
      )}
      <span class="field-remark" role="status">
        {state.remarks.find(mine)?.text ?? ''}
      </span>
    </Field>
  );
}

export function FormRoom({ form }: { form: RobotForm }) {
  const { keys, given } = form.state;
  const sections = [...new Set(keys.map(({ name }) => sectionOf(name)))];
  return (
    <div class="robot-form">
      {sections.map((section) => {
        const of = keys.filter(({ name }) => sectionOf(name) === section);
        const isOpen = section !== 'layout' || of.some(({ name }) => name in given);
        return (
          <details class="card" open={isOpen} data-section={section} key={section}>
            <summary>
              <h2>{titles[section] ?? section}</h2>
            </summary>
            <div class="parameters">
              {of.map((key) => (
                <Row key={key.name} form={form} of={key} />
              ))}
            </div>
          </details>
        );
      })}
    </div>
  );
}
