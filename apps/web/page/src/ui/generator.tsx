// What a generator of mazes is asked for: its kind, the size, the seed, the share of loops.
import type { About, Named } from '../core/types';
import { NumberInput, numberOf, Select } from './controls';
import { errorAt, Field } from './field';

/** As it was typed. */
export interface Generation {
  generator: string;
  width: string;
  height: string;
  seed: string;
  loops: string;
}

export const firstGeneration = (generator: string): Generation => ({
  ...{ generator, width: '16', height: '16' },
  ...{ seed: '1', loops: '0' },
});

/** What is deterministic needs no seed. */
const isSeeded = (generator: string, more: Named[]) => !['empty', ...more.map(({ name }) => name)].includes(generator);

export function orderOf({ generator, width, height, seed, loops }: Generation, more: Named[] = []) {
  const seeded = isSeeded(generator, more);
  return {
    generator,
    width: numberOf(width),
    height: numberOf(height),
    seed: seeded ? numberOf(seed) : 1,
    loops: seeded ? numberOf(loops) : 0,
  };
}

interface Props {
  about: About;
  generation: Generation;
  change(next: Generation): void;
  /** What is wrong with it, said at its field where it names one. */
  error: string;
  /** Kinds beside those of the core. */
  more?: Named[];
}

const fields: (keyof Generation)[] = ['generator', 'width', 'height', 'seed', 'loops'];

export function Generator({ about, generation, change, error, more = [] }: Props) {
  const kinds = [...about.generators, ...more];
  const at = errorAt(error, fields, 'generator');
  const set = (name: keyof Generation) => (value: string) => change({ ...generation, [name]: value });
  const whole = (label: string, name: keyof Generation, min: number, max?: number) => (
    <Field label={label} error={at(name)}>
      <NumberInput inputMode="numeric" {...{ min, max }} value={generation[name]} change={set(name)} />
    </Field>
  );
  return (
    <div class="generator">
      <Field
        label="Kind"
        error={at('generator')}
        help={kinds.find(({ name }) => name === generation.generator)?.summary ?? ''}
      >
        <Select options={kinds.map(({ name }) => name)} value={generation.generator} choose={set('generator')} />
      </Field>
      <div class="field-row">
        {whole('Width', 'width', 1, about.most_side)}
        {whole('Height', 'height', 1, about.most_side)}
      </div>
      <div class="field-row" hidden={!isSeeded(generation.generator, more)}>
        {whole('Seed', 'seed', 0)}
        <Field label="Loops" error={at('loops')} help="share of the remaining walls to open, 0 to 1">
          <NumberInput
            {...{ inputMode: 'decimal', step: 0.01, min: 0, max: 1 }}
            value={generation.loops}
            change={set('loops')}
          />
        </Field>
      </div>
    </div>
  );
}
