// The part of the view in which mice are compared until it is decided which is better.
import { useState } from 'preact/hooks';
import type { About, ComparedMouse, Comparison, WorldInPage } from '../core/types';
import type { EarlyPage } from '../page/page';
import { createWorldChoice, WorldFields } from '../choice/world-choice';
import { createMazePicks, createPicks, PickList } from '../choice/picks';
import { compareMice, testOf, usualTest, type ComparisonRequest, type TestFields } from '../results/comparing';
import { mazesOf } from '../results/holding';
import { Button, NumberInput, Select } from '../ui/controls';
import { Field } from '../ui/field';
import { counted, number, signed } from '../ui/format';
import { firstGeneration, Generator, orderOf } from '../ui/generator';
import { Scrolling, Table } from '../ui/table';
import { createRunning } from './running';

export type ComparePanel = ReturnType<typeof createComparePanel>;

const candidatesOf = ({ mice }: About, world: WorldInPage, first: string) =>
  mice
    .filter(({ name }) => world.mice.includes(name) && name !== first)
    .map(({ name, summary }) => ({ name, about: summary, on: name === 'certify' }));

/** What is compared, where, and how finely. */
export function createComparePanel(page: EarlyPage, about: About, draw: () => void) {
  const world = createWorldChoice(about, enter);
  const fields = { first: 'flood', mazes: 'generated', generation: firstGeneration('contest'), ...usualTest };
  const candidates = createPicks('Candidates', candidatesOf(about, about.worlds[0], fields.first));
  const mazes = createMazePicks('Mazes', about, page.mazes, false);
  const running = createRunning<Comparison>(page, 'paired_shares', draw);
  /** Offers the mice of the chosen world. */
  function enter() {
    const { world: where } = world.chosen();
    if (!where.mice.includes(fields.first)) [fields.first] = where.mice;
    candidates.offer(candidatesOf(about, where, fields.first));
    draw();
  }
  async function request(): Promise<ComparisonRequest> {
    const { world: where, settings } = world.chosen();
    const { generation, first } = fields;
    const chosen = fields.mazes === 'generated' ? null : await mazesOf(page.core, mazes.chosenMazes());
    return {
      ...{ ...settings, world: where.name, mice: [first, ...candidates.chosen()] },
      ...{ ...testOf(fields), ...orderOf(generation), ...(chosen && { mazes: chosen }) },
    };
  }
  return {
    about,
    world,
    candidates,
    mazes,
    fields,
    running,
    change(changes: Partial<typeof fields>) {
      Object.assign(fields, changes);
      enter();
    },
    async start() {
      if (candidates.chosen().length === 0) return page.complain('Choose at least one candidate.');
      const asked = await request();
      await running.run((report, wanted) => compareMice(page.core, asked, report, wanted));
    },
  };
}

const rowOf = ({ mouse, pairs, share, first_share, difference, interval, verdict }: ComparedMouse) => [
  mouse,
  pairs,
  number(share, 3),
  number(first_share, 3),
  signed(difference, 4),
  `${signed(interval[0], 4)} to ${signed(interval[1], 4)}`,
  verdict,
];

/** What is known so far. */
function Verdicts({ comparison }: { comparison: Comparison }) {
  const { first, raced_in, skipped, exact, alpha, candidates } = comparison;
  const interval = exact ? 'Exact difference' : `${100 * (1 - alpha)} % interval`;
  const heads = ['Candidate', 'Mazes', 'Share', `Share of ${first}`, 'Difference', interval, 'Verdict'];
  const skips = skipped > 0 ? `, of which ${skipped} did not count` : '';
  return (
    <>
      <p class="note" role="status">{`${counted(raced_in, 'maze')} so far${skips}.`}</p>
      <Scrolling label="Verdicts">
        <Table
          label={`Shares of the best possible score against ${first}`}
          heads={heads}
          rows={candidates.map(rowOf)}
        />
      </Scrolling>
    </>
  );
}

interface TestInputProps {
  label: string;
  help: string;
  value: string;
  change(text: string): void;
  limits: { min: number; max: number; step: number | 'any' };
}

const TestInput = ({ label, help, limits, ...more }: TestInputProps) => (
  <Field label={label} help={help}>
    <NumberInput {...{ inputMode: 'decimal', required: true }} {...limits} {...more} />
  </Field>
);

const risk = { min: 0.0001, max: 0.5, step: 'any' } as const;

/** How the test decides: the options of `labmouse compare`. */
function TestForm({ fields, change }: { fields: TestFields; change(changes: Partial<TestFields>): void }) {
  const { alpha, beta, most, test } = fields;
  return (
    <div class="field-row">
      <TestInput
        {...{ label: 'Alpha', help: 'largest probability of a verdict without a difference' }}
        {...{ limits: risk, value: alpha, change: (alpha) => change({ alpha }) }}
      />
      <TestInput
        {...{ label: 'Beta', help: 'largest probability of overlooking a difference that matters' }}
        {...{ limits: risk, value: beta, change: (beta) => change({ beta }) }}
      />
      <TestInput
        {...{ label: 'Most mazes', help: 'then it ends undecided' }}
        {...{ limits: { min: 1, max: 20000, step: 1 }, value: most, change: (most) => change({ most }) }}
      />
      <Field label="Test">
        <Select
          options={[
            ['bets', 'bets: keeps alpha and beta whatever the scores'],
            ['gsprt', 'GSPRT: fewer mazes, keeps them approximately'],
          ]}
          value={test}
          choose={(test) => change({ test })}
        />
      </Field>
    </div>
  );
}

function Form({ panel }: { panel: ComparePanel }) {
  const { about, world, candidates, mazes, fields, running, change, start } = panel;
  const { isBusy, shown } = running.state;
  const submit = (event: Event) => {
    event.preventDefault();
    void start();
  };
  return (
    <form class="hold compare" onSubmit={submit}>
      <WorldFields choice={world} />
      <div class="field-row">
        <Field label="First mouse" help="The candidates are compared with it.">
          <Select options={world.chosen().world.mice} value={fields.first} choose={(first) => change({ first })} />
        </Field>
        <Field label="Smallest difference" help="of the share of the best possible score that matters">
          <NumberInput
            {...{ inputMode: 'decimal', min: 0.0001, max: 0.5, step: 'any', required: true }}
            value={fields.betterBy}
            change={(betterBy) => change({ betterBy })}
          />
        </Field>
      </div>
      <TestForm {...{ fields, change }} />
      <PickList picks={candidates} />
      <Field label="Mazes">
        <Select
          options={[
            ['generated', 'generated: the verdict is about all such mazes'],
            ['chosen', 'chosen: the verdict is about these'],
          ]}
          value={fields.mazes}
          choose={(mazes) => change({ mazes })}
        />
      </Field>
      {fields.mazes === 'chosen' ? (
        <PickList picks={mazes} />
      ) : (
        <Generator
          {...{ about, generation: fields.generation, error: '' }}
          change={(generation) => change({ generation })}
        />
      )}
      <div class="row">
        <button type="submit" class="main" disabled={isBusy}>
          Compare
        </button>
        {isBusy && <Button label="Stop" act={running.stop} />}
        {isBusy && <span class="note">running contests until it is decided</span>}
      </div>
      {shown && <Verdicts comparison={shown} />}
    </form>
  );
}

/** `panel`: null while the core starts. */
export function ComparePart({ panel }: { panel: ComparePanel | null }) {
  const [isOpen, open] = useState(false);
  return (
    panel && (
      <details class="part controls" onToggle={({ currentTarget }) => open(currentTarget.open)}>
        <summary>Compare mice until it is decided which is better</summary>
        <p class="note">
          All mice race in the same mazes, until the test decides. It compares the shares of the best possible score.
        </p>
        {isOpen && <Form panel={panel} />}
      </details>
    )
  );
}
