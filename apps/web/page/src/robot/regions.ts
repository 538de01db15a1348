// Which route of a maze wins for which robot, as one or two of its numbers vary: a form, the diagram, and a table.
import { Stopped } from '../core/client';
import type { MazeData, RobotKey, RobotValue, RouteRegion, RouteRegions, VariedRange } from '../core/types';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import { complainAt, field } from '../ui/field';
import { scrolling, table } from '../ui/table';
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

export type Regions = ReturnType<typeof createRegions>;

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

const tableOf = (label: string, heads: string[], rows: string[][]): HTMLElement =>
  scrolling(`${label}, table`, table({ 'aria-label': label }, heads, rows), 'scroll');

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
export function regionTable({ vary, and, routes, rows }: RouteRegions): HTMLElement {
  const cellsOf = (route: string) => String(routes.find(({ name }) => name === route)?.cells ?? '');
  if (!and)
    return tableOf(
      'Which route wins',
      ['route', 'cells', `from ${withUnit(vary)}`, 'to', 's at from', 's at to', 'lead in the middle'],
      rows[0].regions.map((region) => regionRow(region, cellsOf)),
    );
  return tableOf(
    'Which route wins',
    [withUnit(and), `route, the ${vary.key} from which the next one wins, that route, …`],
    [...rows].reverse().map(({ at, regions }) => [valueText(at!), rowText(regions)]),
  );
}

/** A number and how far it varies. */
function createRange(label: string, keys: RobotKey[], optional: boolean) {
  const key = h('select', { onchange: () => suggest() });
  const number = (name: string) =>
    h('input', { type: 'number', step: 'any', inputmode: 'decimal', 'aria-label': name });
  const [from, to] = [number(`${label}: from`), number(`${label}: to`)];
  const unit = h('span');
  const row = h('div.field', h('span.label', 'Range'), h('div.row', from, 'to', to));
  let values: Values = {};
  function suggest() {
    const chosen = keys.find(({ name }) => name === key.value);
    const value = values[key.value];
    row.hidden = !chosen;
    unit.textContent = chosen?.unit ?? '';
    if (!chosen || typeof value !== 'number') return;
    const range = usualRange(chosen, value).map((end) => Number(end.toPrecision(4)));
    [from.value, to.value] = range.map(String);
  }
  return {
    field: field(label, key, unit),
    row,
    /** Those that a robot has; what was chosen stays, with its range, where it can. */
    offer(now: Values, usual: string) {
      values = now;
      const before = key.value;
      const names = keys.filter((one) => isVaried(one, now[one.name])).map(({ name }) => name);
      const choices = optional ? ['', ...names] : names;
      key.replaceChildren(...choices.map((name) => h('option', { value: name }, name || 'nothing else')));
      key.value = [before, usual].find((name) => choices.includes(name)) ?? choices[0] ?? '';
      if (key.value !== before || from.value === '') suggest();
    },
    /** Chooses that, or nothing; throws in words where a robot has no such number. */
    choose(range: VariedRange | undefined) {
      const wanted = range?.key ?? '';
      if (![...key.options].some(({ value }) => value === wanted))
        throw new Error(
          `This link cannot be followed: no number '${wanted.slice(0, 40)}' of this robot can be varied.`,
        );
      key.value = wanted;
      suggest();
      if (range) [from.value, to.value] = [range.from, range.to].map(String);
    },
    /** Null where nothing is varied. */
    read: (): VariedRange | null =>
      key.value === '' ? null : { key: key.value, from: from.valueAsNumber, to: to.valueAsNumber },
  };
}

/** The diagram, the table, and both as files; `address` is that of the diagram. */
function diagramOf(page: Page, regions: RouteRegions, svg: string, address: string): HTMLElement[] {
  const { vary, and, maze, robot } = regions;
  const what = `Which route of ${maze} wins for which ${robot}, as ${vary.key}${and ? ` and ${and.key}` : ''} vary`;
  const picture = h('img', { src: address, alt: `${what}. The table below has the same numbers.` });
  const json = () => `${JSON.stringify(regions, null, 2)}\n`;
  return [
    scrolling('Diagram', picture, 'scroll'),
    regionTable(regions),
    h(
      'p.note',
      'A route counts by the passages that it leads through. A region between two neighbours with the same route is missed.',
    ),
    h(
      'div.row',
      button('Save diagram (SVG)', () => page.save(`${maze}-regions.svg`, svg, 'image/svg+xml')),
      button('Save as JSON', () => page.save(`${maze}-regions.json`, json(), 'application/json')),
    ),
  ];
}

const sectionOf = (form: HTMLElement[], buttons: HTMLElement[], ...answer: HTMLElement[]) =>
  h(
    'section.regions',
    { 'aria-label': 'Which route wins' },
    h('h3', 'Which route wins, for which robot'),
    h(
      'p.note',
      'Vary a number of this robot, or two: the regions are found in which one route of this maze stays the fastest.',
    ),
    h('div.regions-form', ...form),
    h('div.row', ...buttons),
    ...answer,
  );

/** One number that varies, or two. */
function createForm(keys: RobotKey[]) {
  const vary = createRange('Vary', keys, false);
  const along = createRange('and', keys, true);
  return {
    rows: [vary.field, vary.row, along.field, along.row],
    offer(values: Values) {
      vary.offer(values, usualKey);
      along.offer(values, '');
    },
    choose(question: Question) {
      vary.choose(question.vary);
      along.choose(question.and);
    },
    /** Null where nothing is varied. */
    read() {
      const [across, second] = [vary.read(), along.read()];
      return across && { vary: across, ...(second && { and: second }) };
    },
    /** Says it at the number that it names. */
    complain(message: string) {
      const words = message.replaceAll(/'(vary|and)\.(from|to|key)'/g, "'$1'");
      complainAt({ vary: vary.field, and: along.field }, 'vary', words);
    },
  };
}

type Subjects = () => Subject | null;

/** The regions that were found, or why there are none. */
function createFound(page: Page) {
  const says = h('p.note', { role: 'status' });
  const element = h('div.regions-found');
  let address = '';
  return {
    says,
    element,
    clear() {
      if (address) URL.revokeObjectURL(address);
      address = '';
      element.replaceChildren();
    },
    show(regions: RouteRegions, svg: string) {
      const { length } = regions.routes;
      address = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
      says.textContent = `${length === 1 ? 'One route wins' : `${length} routes win`} somewhere in this range.`;
      element.append(...diagramOf(page, regions, svg, address));
    },
  };
}

/**
 * `subject` is null while there is no robot or no maze; `changed` hears before and after each question that is
 * asked here.
 */
export function createRegions(page: Page, keys: RobotKey[], subject: Subjects, changed: () => void) {
  const form = createForm(keys);
  const found = createFound(page);
  const ask = () => (changed(), void start().finally(changed));
  const find = button('Find which route wins', ask, { class: 'main' });
  const stop = button('Stop', () => page.core.stop('regions'), { hidden: true });
  const busy = (is: boolean) => (stop.hidden = !(find.disabled = is));
  let offered = '';
  let number = 0;
  let asked: Question = {};

  /** Whatever was asked and found goes, and this is said in its place. */
  function begin(question: Question, words: string) {
    form.complain('');
    found.clear();
    asked = question;
    found.says.textContent = words;
  }
  async function start() {
    const about = subject();
    const question = form.read();
    if (!about || !question) return void (found.says.textContent = 'There is no robot, or no maze.');
    const mine = ++number;
    begin(question, 'Planning …');
    busy(true);
    try {
      const { regions, svg } = await page.core.call('regions', { ...about, ...question });
      if (mine === number) found.show(regions, svg);
    } catch (error) {
      if (mine !== number) return;
      const isStopped = error instanceof Stopped;
      begin({}, isStopped ? 'Stopped.' : '');
      if (!isStopped) form.complain(errorText(error));
    } finally {
      if (mine === number) busy(false);
    }
  }
  return {
    element: sectionOf(form.rows, [find, stop], found.says, found.element),
    /** Offers the numbers of a robot in a maze; what was found goes where it is of another one. */
    offer(values: Values, maze: MazeData | null) {
      const now = JSON.stringify([values, maze]);
      if (now === offered) return;
      offered = now;
      form.offer(values);
      const isOld = find.disabled || found.element.childElementCount > 0;
      if (find.disabled) page.core.stop('regions');
      number += 1;
      busy(false);
      begin({}, isOld ? 'The robot or the maze is another one now: find it again.' : '');
    },
    /** What is shown here, or on its way; nothing where nothing is. */
    question: () => asked,
    /** Puts that into the form and finds it; throws in words where the robot has no such number. */
    find(question: Question) {
      form.choose(question);
      void start();
    },
  };
}
