// Controls that stand in many places.

/** What a control may have besides its value; a field gives some of it. */
export interface Attributes {
  id?: string;
  required?: boolean;
  disabled?: boolean;
  'aria-label'?: string;
  'aria-describedby'?: string;
  'aria-invalid'?: 'true';
  'data-key'?: string;
}

interface ButtonProps {
  label: string;
  act(): unknown;
  class?: string;
  title?: string;
  disabled?: boolean;
  hidden?: boolean;
}

/** A button that sends no form. */
export const Button = ({ label, act, ...more }: ButtonProps) => (
  <button type="button" {...more} onClick={() => void act()}>
    {label}
  </button>
);

interface NumberProps extends Attributes {
  min?: number;
  max?: number;
  step?: number | 'any';
  inputMode?: 'decimal' | 'numeric';
  placeholder?: string;
  /** As it was typed, which may be no number. */
  value: string;
  /** Hears what is typed, and whether the browser can make a number of it. */
  change(text: string, isValid: boolean): void;
}

/** A number; what is typed is kept as text, and is empty where it is none. */
export const NumberInput = ({ change, ...more }: NumberProps) => (
  <input
    type="number"
    step={1}
    {...more}
    onInput={({ currentTarget: { value, validity } }) => change(value, !validity.badInput)}
  />
);

/** What is typed, as a number; nothing is no 0. */
export const numberOf = (text: string) => (text === '' ? NaN : Number(text));

interface SelectProps extends Attributes {
  /** Each a value that is its label, or a value and a label. */
  options: (string | (string | number)[])[];
  value: string | number;
  choose(value: string): void;
}

/** A list to choose one from, by value and label. */
export const Select = ({ options, choose, ...more }: SelectProps) => (
  <select {...more} onChange={({ currentTarget }) => choose(currentTarget.value)}>
    {options.map((option) => {
      const [value, label = value] = [option].flat();
      return <option value={value}>{label}</option>;
    })}
  </select>
);

interface CheckProps {
  label: string;
  checked: boolean;
  change(checked: boolean): void;
  class?: string;
  disabled?: boolean;
}

export const Check = ({ label, change, class: name = 'check', ...more }: CheckProps) => (
  <label class={name}>
    <input type="checkbox" {...more} onChange={({ currentTarget }) => change(currentTarget.checked)} />
    {label}
  </label>
);
