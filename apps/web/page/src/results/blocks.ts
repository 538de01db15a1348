// The blocks that a report page carries: base64 of gzip of JSON, in script elements that no browser runs.
import { unpack } from '../core/unpack';
import type { RaceResults, Report, ReportRecords } from '../core/types';

const format = 2;

/** The text of the block of that name; null where the page has none. */
export const blockText = (id: string): string | null => document.getElementById(id)?.textContent?.trim() ?? null;

async function readJson(text: string, what: string): Promise<unknown> {
  try {
    return JSON.parse(new TextDecoder().decode(await unpack(text.replace(/\s+/g, ''))));
  } catch {
    throw new Error(
      `The ${what} in this page cannot be read: the file is incomplete or damaged. Make it again with 'labmouse report'.`,
    );
  }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const named = (value: unknown) => isObject(value) && typeof value.name === 'string';

const listOf = (value: unknown, each: (entry: unknown) => boolean) => Array.isArray(value) && value.every(each);

const isResult = (value: unknown) =>
  isObject(value) && typeof value.maze === 'string' && typeof value.outcome === 'string';

const isMouse = (value: unknown) => named(value) && listOf((value as Record<string, unknown>).results, isResult);

/** Whether that has the lists of a race, so that it can be shown. What the numbers are worth is for the core to know. */
export function isResults(value: unknown): value is RaceResults {
  const isGroup = (group: unknown) => isObject(group) && listOf(group.mazes, named) && listOf(group.mice, isMouse);
  return isObject(value) && listOf(value.groups, isGroup);
}

/** The report of that block's text; throws what is wrong with it, in words. */
export async function readReport(text: string): Promise<Report> {
  const json = await readJson(text, 'report');
  if (!isObject(json) || json.labmouse !== 'report')
    throw new Error('This page contains something that is not a labmouse report');
  if (json.format !== format) {
    const version = typeof json.version === 'string' ? `, made by labmouse ${json.version}` : '';
    throw new Error(
      `The report in this page has format ${String(json.format).slice(0, 20)}${version}; this page reads format ${format}. ` +
        `Make it again with 'labmouse report'.`,
    );
  }
  if (!isResults(json.results)) throw new Error('The report in this page has no results');
  const mazes = isObject(json.mazes) ? json.mazes : {};
  const links = Object.entries(mazes).filter(([, link]) => typeof link === 'string');
  return { ...(json as unknown as Report), mazes: Object.fromEntries(links) as Record<string, string> };
}

/** The records of that block's text; throws what is wrong with them, in words. */
export async function readRecords(text: string): Promise<ReportRecords> {
  const json = await readJson(text, 'records');
  if (!isObject(json) || !Array.isArray(json.records))
    throw new Error('The records in this page have an unknown format');
  const records = json.records.filter(
    (one) => isObject(one) && typeof one.mouse === 'string' && typeof one.maze === 'string',
  );
  return { records, left_out: typeof json.left_out === 'number' ? json.left_out : 0 };
}
