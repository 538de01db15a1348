// Which mouse runs, with which parameters.
import type { Mouse, Parameter } from '../core/types';
import { Copyable } from '../ui/copy';
import { Button, Select } from '../ui/controls';
import { Field } from '../ui/field';
import { ParameterField } from './parameters';
import { readSpec, specOf, type Values } from './spec';

export type MouseChoice = ReturnType<typeof createMouseChoice>;

/** The one to begin with: it has parameters, and reasons. */
const isUsual = (name: string) => name === 'ariadne';

/** `changed` hears of what is chosen in the form. */
export function createMouseChoice(mice: Mouse[], changed: () => void) {
  const state = {
    mouse: (mice.find(({ name }) => isUsual(name)) ?? mice[0]).name,
    /** What the form does not show stays until another mouse is chosen or all go back to their defaults. */
    values: {} as Values,
    unit: 'steps' as 'steps' | 'seconds',
    /** What the core says is wrong with it. */
    error: '',
    /** Counts up where the form has other values than those typed in it. */
    version: 0,
  };
  const entry = () => mice.find(({ name }) => name === state.mouse);
  const counts = ({ counts_in }: Parameter) => !counts_in || counts_in === state.unit;
  function set(mouse: string, values: Values) {
    Object.assign(state, { mouse, values, version: state.version + 1 });
  }
  return {
    mice,
    state,
    entry,
    /** Those that count in its world. */
    parameters: () => (entry()?.parameters ?? []).filter(counts),
    spec: () => specOf(state.mouse, state.values, mice),
    /** Shows the parameters that count there. */
    playIn: (where: typeof state.unit) => void (state.unit = where),
    /** Another mouse, by its SPEC, right or wrong. */
    choose(text: string) {
      const { mouse, values } = readSpec(text);
      set(mouse, { ...values });
    },
    /** Says at the field that a message of the core speaks of what is wrong; nothing where it is empty. */
    complain: (message: string) => void (state.error = message),
    /** By hand. */
    pick(mouse: string) {
      set(mouse, {});
      changed();
    },
    change(name: string, value: string | null) {
      const { [name]: _, ...others } = state.values;
      state.values = value === null ? others : { ...others, [name]: value };
      changed();
    },
  };
}

/** The parameter that a message of the core names; null where the form has none of that name. */
const namedIn = (error: string, parameters: Parameter[]) =>
  parameters.find(({ name }) => error.includes(`parameter '${name}'`))?.name ?? null;

export function MouseCard({ choice: { mice, state, entry, parameters, spec, pick } }: { choice: MouseChoice }) {
  const { mouse, error } = state;
  const options = mice.map(({ name, summary }) => [name, `${name} · ${summary}`]);
  return (
    <section class="card" aria-label="Mouse">
      <h2>Mouse</h2>
      <Field label="Name" help={entry()?.summary ?? ''} error={namedIn(error, parameters()) ? '' : error}>
        <Select options={options} value={mouse} choose={pick} />
      </Field>
      <div class="field">
        <span class="label">For the command line</span>
        <Copyable label="The mouse for the command line" text={spec()} />
      </div>
    </section>
  );
}

const isWide = matchMedia('(min-width: 60rem)');

export function ParametersCard({ choice: { state, parameters, spec, pick, change } }: { choice: MouseChoice }) {
  const { mouse, values, version, error } = state;
  const all = parameters();
  const named = namedIn(error, all);
  return (
    <details class="card" open={isWide.matches}>
      <summary>
        <h2>Parameters</h2>
      </summary>
      <Button label="Back to defaults" disabled={spec() === mouse} act={() => pick(mouse)} />
      <div class="parameters">
        {all.map((parameter) => (
          <ParameterField
            key={`${version} ${parameter.name}`}
            parameter={parameter}
            given={values}
            error={named === parameter.name ? error : ''}
            change={(value) => change(parameter.name, value)}
          />
        ))}
        {all.length === 0 && <p class="note">This mouse has no parameters.</p>}
      </div>
    </details>
  );
}
