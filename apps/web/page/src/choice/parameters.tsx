// The parameters of a mouse as a form, built from its table.
import { useState } from 'preact/hooks';
import type { Parameter } from '../core/types';
import { NumberInput, Select, type Attributes } from '../ui/controls';
import { Field } from '../ui/field';
import { valueOf, type Values } from './spec';

/** More choices than that are easier to find by typing. */
const longList = 12;

/** What is given has to be shown, even where it is no choice: the core says what is wrong with it. */
const withGiven = (choices: string[], value: string) => (choices.includes(value) ? choices : [value, ...choices]);

/** The core has longer names for some types where it writes for people. */
const types: Record<string, Parameter['type']> = { 'whole number': 'whole', number: 'real', 'yes/no': 'flag' };
export const typeOf = ({ type }: Parameter) => types[type] ?? type;
const isNumber = (parameter: Parameter) => typeOf(parameter) === 'whole' || typeOf(parameter) === 'real';

interface ControlProps extends Attributes {
  parameter: Parameter;
  /** As it was typed. */
  value: string;
  /** Hears what was typed, and whether the browser can make something of it; of a flag `yes` or `no`. */
  change(text: string, isValid: boolean): void;
}

export function Control({ parameter, value, change, ...more }: ControlProps) {
  const { name, low, high, choices = [] } = parameter;
  if (typeOf(parameter) === 'flag') {
    const isOn = value === 'yes' || value === 'true';
    const turn = (is: boolean) => change(is ? 'yes' : 'no', true);
    return (
      <input type="checkbox" {...more} checked={isOn} onInput={({ currentTarget }) => turn(currentTarget.checked)} />
    );
  }
  if (isNumber(parameter)) {
    const step = typeOf(parameter) === 'whole' ? 1 : 'any';
    return <NumberInput inputMode="decimal" {...more} {...{ min: low, max: high, step, value, change }} />;
  }
  if (choices.length > 0 && choices.length <= longList) {
    const options = withGiven(choices, value);
    return <Select {...more} options={options} value={value} choose={(chosen) => change(chosen, true)} />;
  }
  const list = choices.length > 0 ? `choices-${name}` : undefined;
  return (
    <>
      <input
        type="text"
        spellcheck={false}
        autocomplete="off"
        {...more}
        list={list}
        value={value}
        onInput={({ currentTarget }) => change(currentTarget.value, true)}
      />
      {list && (
        <datalist id={list}>
          {choices.map((one) => (
            <option value={one} />
          ))}
        </datalist>
      )}
    </>
  );
}

function helpFor(parameter: Parameter): string {
  const { meaning, low, high } = parameter;
  const range = isNumber(parameter) && low !== undefined ? `; ${low} to ${high}` : '';
  return `${meaning}${range}; default ${parameter.default}`;
}

interface Props {
  parameter: Parameter;
  given: Values;
  error: string;
  /** Hears its value; null for the default. */
  change(value: string | null): void;
}

/** What was typed stays until its key is another one. */
export function ParameterField({ parameter, given, error, change }: Props) {
  const [typed, type] = useState({ text: valueOf(parameter, given), isValid: true });
  const set = (text: string, isValid: boolean) => {
    type({ text, isValid });
    const value = text.trim();
    if (isValid) change(value === '' || value === parameter.default ? null : value);
  };
  return (
    <Field
      label={parameter.name}
      class={typeOf(parameter) === 'flag' ? 'check' : ''}
      help={helpFor(parameter)}
      error={typed.isValid ? error : 'not a number'}
    >
      <Control parameter={parameter} value={typed.text} change={set} />
    </Field>
  );
}
