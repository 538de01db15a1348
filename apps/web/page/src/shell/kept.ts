// What was open when the page was closed: written as it changes, read like files that anybody may have changed.
import type { Core } from '../core/client';
import type { MazeData, Play, RaceResults } from '../core/types';
import { readAddress, type Moment } from '../link/address';
import type { KeptRobot } from '../link/my-robot';
import type { Shelf } from '../page/shelf';

/** Of one thing, in characters; what is larger is opened again from its file. */
const most = 20_000_000;
const mostMazes = 50;

export interface Opened {
  plays: { play: Play; record: string }[];
  moment: Moment | null;
}

const isText = (value: unknown): value is string => typeof value === 'string' && value.length <= most;
const texts = (value: unknown): string[] => (Array.isArray(value) ? value.filter(isText) : []);
const bytesOf = (text: string) => new TextEncoder().encode(text);

export function createKeeper(core: Core, shelf: Shelf) {
  const linksOf = (mazes: MazeData[]) =>
    Promise.all(mazes.slice(-mostMazes).map(async (maze) => (await core.call('link', { maze })).link));
  /** What cannot be kept is not: that is no news for anybody. */
  const keep = (key: string, making: () => Promise<unknown>) => {
    if (shelf.keeps())
      void making().then(
        (value) => shelf.write(key, value),
        () => undefined,
      );
  };
  return {
    mazes: (mazes: MazeData[]) => keep('mazes', () => linksOf(mazes)),
    plays(plays: { play: Play; record: string }[]) {
      const kept = plays.filter(({ record }) => record !== '' && record.length <= most);
      keep('plays', async () => {
        const mazes = await linksOf(kept.map(({ play }) => play.maze));
        return kept.map(({ record }, i) => ({ record, maze: mazes[i] }));
      });
    },
    /** Where the replay is, as `addressOf` has it. */
    moment: (address: string) => keep('moment', async () => address),
    results: (results: RaceResults, raced: MazeData[]) =>
      keep('results', async () => {
        const text = JSON.stringify(results);
        return text.length > most ? null : { text, raced: await linksOf(raced) };
      }),
  };
}

/** A robot that was kept; what is no robot is not kept either. */
async function robotOf(core: Core, kept: unknown): Promise<KeptRobot | null> {
  const { name, text, origin } = (kept ?? {}) as Record<string, unknown>;
  const from = (origin ?? {}) as Record<string, unknown>;
  if (!isText(name) || !isText(text) || !isText(from.name)) return null;
  const files = [{ name, text }, ...(isText(from.text) ? [{ name: from.name, text: from.text }] : [])];
  const answers = files.map((one) => core.call('robot', { name: one.name }, bytesOf(one.text)).catch(() => null));
  if (!isText(from.text) && !(await core.call('about', {})).robots.some((one) => one.name === from.name)) return null;
  if ((await Promise.all(answers)).some((answer) => !answer?.result)) return null;
  return { name, text, origin: { name: from.name, text: isText(from.text) ? from.text : null } };
}

export function createFinder(core: Core, shelf: Shelf) {
  const mazeOf = (link: string) =>
    core.call('read_link', { link }).then(
      ({ maze }) => maze,
      () => null,
    );
  const mazesOf = async (value: unknown) =>
    (await Promise.all(texts(value).slice(0, mostMazes).map(mazeOf))).filter((maze) => maze !== null);
  async function playOf(value: unknown) {
    const { record, maze: link } = (value ?? {}) as { record?: unknown; maze?: unknown };
    if (!isText(record) || !isText(link)) return [];
    const maze = await mazeOf(link);
    const opened = await core
      .call('open', { name: 'record', ...(maze && { maze }) }, bytesOf(record))
      .catch(() => null);
    return opened?.kind === 'record' ? [{ play: opened.play, record }] : [];
  }
  /** An address of that view. */
  async function addressAt(view: string, key = view): Promise<string | null> {
    const text = await shelf.read(key);
    return isText(text) && text.startsWith(`#${view}&`) ? text : null;
  }
  async function momentOf(): Promise<Moment | null> {
    const text = await shelf.read('moment');
    try {
      return isText(text) ? readAddress(text).moment : null;
    } catch {
      return null;
    }
  }
  return {
    mazes: async () => mazesOf(await shelf.read('mazes')),
    async plays() {
      const list = await shelf.read('plays');
      const plays = [];
      for (const one of Array.isArray(list) ? list.slice(0, 2) : []) plays.push(...(await playOf(one)));
      return { plays, moment: await momentOf() };
    },
    /** What Live showed, as its address. */
    live: () => addressAt('live'),
    /** What Robot showed beside that, as its address. */
    robotAt: () => addressAt('robot', 'robot-at'),
    async results() {
      const { text, raced } = ((await shelf.read('results')) ?? {}) as { text?: unknown; raced?: unknown };
      if (!isText(text)) return null;
      const opened = await core.call('open', { name: 'results' }, bytesOf(text)).catch(() => null);
      return opened?.kind === 'results' ? { results: opened.results, raced: await mazesOf(raced) } : null;
    },
    /** The robot that was edited, with what it began from. */
    robot: async () => robotOf(core, await shelf.read('robot')),
  };
}
