// Which route of a maze wins for which robot, as one or two of its numbers vary: a form, the diagram, and a table.
import { Stopped } from '../core/client';
import type { MazeData, RobotKey, RobotValue, RouteRegion, RouteRegions, VariedRange } from '../core/types';
import { Button, NumberInput, numberOf, Select } from '../ui/controls';
import { errorAt, Field } from '../ui/field';
import { Scrolling, Table } from '../ui/table';
import type { Page } from '../page/page';
import type { Values } from './form';
import { errorText } from '../ui/format';

/** The robot and the maze that are asked about. */
export interface Subject {
  name: string;
  values: Values;
  maze: MazeData;
}

/** What is varied: one number, or two. */
export interface Question {
  vary?: VariedRange;
  and?: VariedRange;
}

/** Grip, which decides most about routes. */
const usualKey = 'curve.lateral_acceleration';

const isVaried = ({ kind }: RobotKey, value: RobotValue | undefined) =>
  (kind === 'number' || kind === 'number_or_false') && typeof value === 'number';

/** From half of a number to twice of it, as far as a robot may have it. */
export function usualRange({ low, high }: Pick<RobotKey, 'low' | 'high'>, value: number): [number, number] {
  const [from, to] = [Math.max(low, value / 2), Math.min(high, value * 2)];
  return from < to ? [from, to] : [low, high];
}

/** As many digits as tell the values of a range apart. */
export const valueText = (value: number): string => String(Number(value.toPrecision(6)));
const seconds = (microseconds: number) => (microseconds / 1e6).toFixed(3);
const withUnit = ({ key, unit }: { key: string; unit: string }) => (unit ? `${key}, ${unit}` : key);

function regionRow(region: RouteRegion, cellsOf: (route: string) => string): string[] {
  const range = [valueText(region.from), valueText(region.to)];
  if (region.route === null) return ['none', '', ...range, '', '', region.refusal];
  const { runner_up, margin } = region;
  const lead = runner_up === null || margin === null ? '' : `${(100 * margin).toFixed(2)} % ahead of ${runner_up}`;
  return [
    region.route,
    cellsOf(region.route),
    ...range,
    seconds(region.time_from_us),
    seconds(region.time_to_us),
    lead,
  ];
}

/** "A 27431 B": the routes of a row, and between them the values from which the next one wins. */
const rowText = (regions: RouteRegion[]) =>
  regions.map(({ route, from }, i) => `${i > 0 ? `${valueText(from)} ` : ''}${route ?? 'none'}`).join(' ');

/** The regions as a table: a line for each, or for each value of the second number. */
export function RegionTable({ regions: { vary, and, routes, rows } }: { regions: RouteRegions }) {
  const cellsOf = (route: string) => String(routes.find(({ name }) => name === route)?.cells ?? '');
  const label = 'Which route wins';
  const heads = and
    ? [withUnit(and), `route, the ${vary.key} from which the next one wins, that route, …`]
    : ['route', 'cells', `from ${withUnit(vary)}`, 'to', 's at from', 's at to', 'lead in the middle'];
  const lines = and
    ? [...rows].reverse().map(({ at, regions }) => [valueText(at!), rowText(regions)])
    : rows[0].regions.map((region) => regionRow(region, cellsOf));
  return (
    <Scrolling label={`${label}, table`} class="scroll">
      <Table label={label} heads={heads} rows={lines} />
    </Scrolling>
  );
}

/** A number and how far it varies, as they are chosen and typed; no number where the key is empty. */
interface Range {
  key: string;
  from: string;
  to: string;
}

/** The usual range of a number that a robot has. */
function suggested(key: string, keys: RobotKey[], values: Values): Range {
  const chosen = keys.find(({ name }) => name === key);
  const value = values[key];
  if (!chosen || typeof value !== 'number') return { key, from: '', to: '' };
  const [from, to] = usualRange(chosen, value).map((end) => String(Number(end.toPrecision(4))));
  return { key, from, to };
}

const readRange = ({ key, from, to }: Range): VariedRange | null =>
  key === '' ? null : { key, from: numberOf(from), to: numberOf(to) };

/** That of a robot with these values; what was chosen stays, with its range, where it can. */
function offered({ key, from, to }: Range, usual: string, keys: RobotKey[], values: Values): Range {
  const names = keys.filter((one) => isVaried(one, values[one.name])).map(({ name }) => name);
  const choices = usual === '' ? ['', ...names] : names;
  const next = [key, usual].find((one) => choices.includes(one)) ?? choices[0] ?? '';
  return next === key && (from !== '' || key === '') ? { key, from, to } : suggested(next, keys, values);
}

/** That of a link, or none; throws in words where a robot has no such number. */
function linked(range: VariedRange | undefined, choices: string[]): Range {
  const key = range?.key ?? '';
  if (!choices.includes(key))
    throw new Error(`This link cannot be followed: no number '${key.slice(0, 40)}' of this robot can be varied.`);
  return range ? { key, from: String(range.from), to: String(range.to) } : { key, from: '', to: '' };
}

/** Which numbers vary, and what was found or why nothing was. */
function createState() {
  const none: Range = { key: '', from: '', to: '' };
  return {
    values: {} as Values,
    /** What is shown, or on its way. */
    asked: {} as Question,
    vary: none,
    and: none,
    error: '',
    says: '',
    isBusy: false,
    /** With the address of its diagram. */
    found: null as { regions: RouteRegions; svg: string; address: string } | null,
  };
}

type Subjects = () => Subject | null;
export type Regions = ReturnType<typeof createRegions>;

type State = ReturnType<typeof createState>;

/** Null where nothing is varied. */
function questionOf(state: State) {
  const [vary, and] = [readRange(state.vary), readRange(state.and)];
  return vary && { vary, ...(and && { and }) };
}

/** Whatever was asked and found goes, and this is said in its place. */
function begin(state: State, asked: Question, says: string, isBusy = false) {
  if (state.found) URL.revokeObjectURL(state.found.address);
  Object.assign(state, { asked, error: '', says, found: null, isBusy });
}

function show(state: State, regions: RouteRegions, svg: string) {
  const { length } = regions.routes;
  const address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  const says = `${length === 1 ? 'One route wins' : `${length} routes win`} somewhere in this range.`;
  Object.assign(state, { says, found: { regions, svg, address } });
}

function fail(state: State, error: unknown) {
  const isStopped = error instanceof Stopped;
  begin(state, {}, isStopped ? 'Stopped.' : '');
  // Said at the number that it names.
  if (!isStopped) state.error = errorText(error).replaceAll(/'(vary|and)\.(from|to|key)'/g, "'$1'");
}

/**
 * `subject` is null while there is no robot or no maze; `changed` hears before and after each question that is
 * asked here, `draw` is called after each change of what is seen.
 */
export function createRegions(page: Page, all: RobotKey[], subject: Subjects, draw: () => void, changed: () => void) {
  const state = createState();
  let subjectNow = '';
  let number = 0;
  const stop = () => page.core.stop('regions');
  const keys = () => all.filter((one) => isVaried(one, state.values[one.name]));

  async function start() {
    const [about, question] = [subject(), questionOf(state)];
    if (!about || !question) {
      state.says = 'There is no robot, or no maze.';
      return draw();
    }
    const mine = ++number;
    begin(state, question, 'Planning …', true);
    draw();
    try {
      const { regions, svg } = await page.core.call('regions', { ...about, ...question });
      if (mine === number) show(state, regions, svg);
    } catch (error) {
      if (mine === number) fail(state, error);
    }
    if (mine === number) state.isBusy = false;
    draw();
  }
  return {
    page,
    state,
    keys,
    set(which: 'vary' | 'and', range: Partial<Range>) {
      const { key } = range;
      state[which] = key === undefined ? { ...state[which], ...range } : suggested(key, all, state.values);
      draw();
    },
    ask: () => (changed(), void start().finally(changed)),
    stop,
    /** Offers the numbers of a robot in a maze; what was found goes where it is of another one. */
    offer(values: Values, maze: MazeData | null) {
      const before = subjectNow;
      subjectNow = JSON.stringify([values, maze]);
      if (before === subjectNow) return;
      const ranges = { vary: offered(state.vary, usualKey, all, values), and: offered(state.and, '', all, values) };
      Object.assign(state, { values, ...ranges });
      const isOld = state.isBusy || state.found !== null;
      if (state.isBusy) stop();
      number += 1;
      begin(state, {}, isOld ? 'The robot or the maze is another one now: find it again.' : '');
    },
    /** What is shown here, or on its way; nothing where nothing is. */
    question: () => state.asked,
    /** Puts that into the form and finds it; throws in words where the robot has no such number. */
    find(question: Question) {
      const names = keys().map(({ name }) => name);
      Object.assign(state, { vary: linked(question.vary, names), and: linked(question.and, ['', ...names]) });
      void start();
    },
  };
}

/** Chooses one of the numbers, and how far it varies. */
function RangeFields({ regions: { state, keys, set }, which }: { regions: Regions; which: 'vary' | 'and' }) {
  const { key, from, to } = state[which];
  const label = which === 'vary' ? 'Vary' : 'and';
  const names = keys().map(({ name }) => [name, name]);
  const error = errorAt(state.error, ['vary', 'and'], 'vary')(which);
  return (
    <>
      <Field label={label} help={keys().find(({ name }) => name === key)?.unit ?? ''} error={error}>
        <Select
          options={which === 'and' ? [['', 'nothing else'], ...names] : names}
          value={key}
          choose={(key) => set(which, { key })}
        />
      </Field>
      <div class="field" hidden={key === ''}>
        <span class="label">Range</span>
        <div class="row">
          <NumberInput
            {...{ step: 'any', inputMode: 'decimal', 'aria-label': `${label}: from` }}
            value={from}
            change={(from) => set(which, { from })}
          />
          to
          <NumberInput
            {...{ step: 'any', inputMode: 'decimal', 'aria-label': `${label}: to` }}
            value={to}
            change={(to) => set(which, { to })}
          />
        </div>
      </div>
    </>
  );
}

/** The diagram, the table, and both as files. */
function Found({
  page,
  found: { regions, svg, address },
}: {
  page: Page;
  found: NonNullable<Regions['state']['found']>;
}) {
  const { vary, and, maze, robot } = regions;
  const what = `Which route of ${maze} wins for which ${robot}, as ${vary.key}${and ? ` and ${and.key}` : ''} vary`;
  const json = () => `${JSON.stringify(regions, null, 2)}\n`;
  return (
    <>
      <Scrolling label="Diagram" class="scroll">
        <img src={address} alt={`${what}. The table below has the same numbers.`} />
      </Scrolling>
      <RegionTable regions={regions} />
      <p class="note">
        A route counts by the passages that it leads through. A region between two neighbours with the same route is
        missed.
      </p>
      <div class="row">
        <Button label="Save diagram (SVG)" act={() => page.save(`${maze}-regions.svg`, svg, 'image/svg+xml')} />
        <Button label="Save as JSON" act={() => page.save(`${maze}-regions.json`, json(), 'application/json')} />
      </div>
    </>
  );
}

export function RegionsRoom({ regions }: { regions: Regions }) {
  const { page, state, ask, stop } = regions;
  const { isBusy, says, found } = state;
  return (
    <section class="regions" aria-label="Which route wins">
      <h3>Which route wins, for which robot</h3>
      <p class="note">
        Vary a number of this robot, or two: the regions are found in which one route of this maze stays the fastest.
      </p>
      <div class="regions-form">
        <RangeFields regions={regions} which="vary" />
        <RangeFields regions={regions} which="and" />
      </div>
      <div class="row">
        <Button label="Find which route wins" class="main" disabled={isBusy} act={ask} />
        <Button label="Stop" hidden={!isBusy} act={stop} />
      </div>
      <p class="note" role="status">
        {says}
      </p>
      <div class="regions-found">{found && <Found page={page} found={found} />}</div>
    </section>
  );
}
