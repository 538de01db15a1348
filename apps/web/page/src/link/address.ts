// A moment of the page as the text behind the `#` of its address, and back: a view, then what is seen in it.
//
//   replay&mouse=certify&mouse=flood&in=contest-02&seed=1&robot=classic&rules=all-japan&at=12.5&zoom=2,8,8
//
// What comes from a link is read strictly: it was written by anybody.
import type { VariedRange } from '../core/types';
import type { Camera } from '../maze/camera';

export interface Moment {
  /** SPECs, as the command line has them. */
  mice: string[];
  /** Built-in mazes by their names; `all` is all of them. */
  builtin: string[];
  /** Other mazes, each as the core's `link`. */
  mazes: string[];
  /** One for all mice, or one for each. */
  seeds: number[];
  /** Steps of a contest. */
  budget?: number;
  /** Contests of each stochastic mouse. */
  runs?: number;
  /** Of contests in seconds. */
  robot?: string;
  rules?: string;
  /** Another world, and what is set of it where that is not the usual: each a name, =, and its value. */
  world?: string;
  set?: string[];
  /** Of the robot: the number, or the two, over which it is asked which route wins. */
  vary?: VariedRange;
  and?: VariedRange;
  /** Which race of the home page. */
  pair?: number;
  /** On the clock of the contest: steps, or seconds in the other worlds. */
  time?: number;
  /** Where one looks at the maze from; missing for the whole of it. */
  look?: Camera;
}

/** Characters of a link; browsers, mail and chats take so many. */
export const longestLink = 30_000;
const longestText = 2_000;
const mostNames = 500;
/** As the core has it for contests in the page. */
const mostSteps = 1_000_000;
const mostRuns = 100;
const latest = 1e9;
/** Of the numbers of a robot, none of which is below 0. */
const largest = 1e9;
/** Cells; a camera may look from nowhere else. */
const farthest = 1_000;
const closest = 100;

const shown = (text: string) => (text.length > 40 ? `${text.slice(0, 39)}…` : text);

function textOf(key: string, text: string): string {
  if (text === '') throw new Error(`This link is incomplete: nothing follows ${key}=. Copy the whole link again.`);
  if (text.length > longestText) throw new Error(`This link cannot be followed: what follows ${key}= is too long.`);
  return text;
}

/** A number of a link, in digits: no sign, no power. */
function numberOf(key: string, text: string, least: number, most: number, whole: boolean): number {
  const number = /^\d{1,16}(\.\d{1,9})?$/.test(text) ? Number(text) : NaN;
  if (number >= least && number <= most && (!whole || Number.isSafeInteger(number))) return number;
  throw new Error(
    `This link cannot be followed: ${key}=${shown(text)} is no ${whole ? 'whole ' : ''}number from ${least} to ${most}.`,
  );
}

function cameraOf(key: string, text: string): Camera {
  const parts = text.split(',');
  if (parts.length !== 3) throw new Error(`This link cannot be followed: ${key}=${shown(text)} is not three numbers.`);
  const [scale, x, y] = parts.map((part, i) => numberOf(key, part, i ? 0 : 1, i ? farthest : closest, false));
  return { scale, x, y };
}

/** A number of a robot and how far it varies: its key, from, to. */
function rangeOf(key: string, text: string): VariedRange {
  const [name, ...ends] = textOf(key, text).split(',');
  if (ends.length !== 2)
    throw new Error(`This link cannot be followed: ${key}=${shown(text)} is not a key and two numbers.`);
  const [from, to] = ends.map((end) => numberOf(key, end, 0, largest, false));
  return { key: name, from, to };
}

const wholeOf = (least: number, most: number) => (key: string, text: string) => numberOf(key, text, least, most, true);
const listOf = (key: string, text: string) => textOf(key, text).split(',');

/** A SPEC in a link stays legible. */
const legible = (text: string) =>
  encodeURIComponent(text).replace(/%3A/g, ':').replace(/%3D/g, '=').replace(/%2F/g, '/').replace(/%2C/g, ',');

/** No more digits than one can see; never in powers of ten. */
const brief = (number: number) => String(Number(number.toFixed(3)));

/** Its ends in digits; smaller ones would be in powers of ten. */
const rangeText = ({ key, from, to }: VariedRange) =>
  [key, ...[from, to].map((end) => Number(end.toFixed(6)))].join(',');

interface Word {
  field: keyof Moment;
  read(key: string, text: string): unknown;
  /** The text of a value, as it stands where this is missing; undefined where the link says nothing of it. */
  write?(value: never): string | undefined;
  /** It may come more than once, once for each entry of a list. */
  many?: true;
}

const textsOf = (key: string, text: string) => [textOf(key, text)];
const seedsOf = (key: string, text: string) =>
  text.split(',').map((one) => numberOf(key, one, 0, Number.MAX_SAFE_INTEGER, true));
const timeOf = (key: string, text: string) => numberOf(key, text, 0, latest, false);
const listText = (list: unknown[]) => (list.length > 0 ? list.join(',') : undefined);
const cameraText = ({ scale, x, y }: Camera) => (scale > 1 ? [scale, x, y].map(brief).join(',') : undefined);

/** The words of a link, in their order: how each is read and written. */
const words: Record<string, Word> = {
  mouse: { field: 'mice', read: textsOf, many: true },
  in: { field: 'builtin', read: listOf, write: listText },
  maze: { field: 'mazes', read: textsOf, many: true },
  seed: { field: 'seeds', read: seedsOf, write: listText },
  budget: { field: 'budget', read: wholeOf(1, mostSteps) },
  runs: { field: 'runs', read: wholeOf(1, mostRuns) },
  robot: { field: 'robot', read: textOf },
  rules: { field: 'rules', read: textOf },
  world: { field: 'world', read: textOf },
  set: { field: 'set', read: textsOf, many: true },
  vary: { field: 'vary', read: rangeOf, write: rangeText },
  and: { field: 'and', read: rangeOf, write: rangeText },
  pair: { field: 'pair', read: wholeOf(1, 100) },
  at: { field: 'time', read: timeOf, write: brief },
  zoom: { field: 'look', read: cameraOf, write: cameraText },
};

/** The text behind `#`; throws in words where it would be too long for a link. */
export function addressOf(view: string, moment: Partial<Moment>): string {
  const parts = Object.entries(words).flatMap(([key, { field, write = String, many }]) =>
    (many ? ((moment[field] ?? []) as unknown[]) : [moment[field]])
      .map((value) => (value === undefined || value === null ? undefined : write(value as never)))
      .flatMap((value) => (value === undefined ? [] : `${key}=${legible(value)}`)),
  );
  const text = [view, ...parts].join('&');
  if (text.length > longestLink)
    throw new Error('This is too much for a link: choose fewer mazes of your own, or save the results as a file.');
  return text;
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    throw new Error(`This link is cut or mistyped near ${shown(text)}. Copy the whole link again.`);
  }
}

/** Reads what `addressOf` wrote; throws in one line what is wrong with it. */
export function readAddress(hash: string): { view: string; moment: Moment } {
  const text = hash.replace(/^#/, '');
  if (text.length > longestLink) throw new Error(`This link is too long: the limit is ${longestLink} characters.`);
  const [view, ...parts] = text.split('&');
  const moment: Moment = { mice: [], builtin: [], mazes: [], seeds: [] };
  const seen = new Set<string>();
  for (const part of parts) {
    const equals = part.indexOf('=');
    const key = equals < 0 ? part : part.slice(0, equals);
    const word = Object.hasOwn(words, key) ? words[key] : null;
    if (!word || equals < 0) throw new Error(`This link cannot be followed: '${shown(key)}' means nothing here.`);
    if (seen.has(key) && !word.many) throw new Error(`This link cannot be followed: it says ${key}= twice.`);
    seen.add(key);
    const value = word.read(key, decoded(part.slice(equals + 1)));
    const before = word.many ? ((moment[word.field] ?? []) as unknown[]) : [];
    Object.assign(moment, { [word.field]: Array.isArray(value) ? [...before, ...value] : value });
    if (Array.isArray(value) && before.length + value.length > mostNames)
      throw new Error(`This link cannot be followed: it says ${key}= more than ${mostNames} times.`);
  }
  return { view, moment };
}
