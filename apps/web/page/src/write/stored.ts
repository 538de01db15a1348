// What somebody wrote, kept in the browser. All tabs share one storage: each tab has an id, and no tab overwrites what
// another one wrote without keeping that under the other's id.
import { besides as key } from '../page/shelf';
import { jsonOf, readWork, type Work } from './keeping';

/** A program that another tab has overwritten, and the name under which it is kept. */
export interface Other {
  name: string;
  work: Work;
}

export type Stored = ReturnType<typeof createStored>;

/** The name of what stood there before. */
export const before = 'before';
const asideKey = `${key}-of-`;
const keyOf = (name: string) => `${key}-${name}`;

/** Who wrote it; programs of earlier versions do not say. */
function writerOf(json: string): string {
  try {
    const { by } = JSON.parse(json) as { by?: unknown };
    return typeof by === 'string' && /^\w{1,20}$/.test(by) ? by : 'earlier';
  } catch {
    return 'earlier';
  }
}

const isTemplate = ({ language, text }: Work) => language.templates.some((one) => one.text === text);

/** What was written last, or last in that language, by any tab. */
export function kept(id?: string): Work | null {
  try {
    return readWork(localStorage.getItem(id ? keyOf(id) : key) ?? '');
  } catch {
    return null;
  }
}

/** Keeps what is about to be overwritten, or was, under the id of who wrote it. */
function putAside(storage: Storage, name: string, json: string) {
  const work = readWork(json);
  if (work && !isTemplate(work)) storage.setItem(`${asideKey}${writerOf(json)}-${name}`, json);
}

function othersIn(storage: Storage): Other[] {
  const names = Object.keys(storage).filter((name) => name.startsWith(asideKey));
  return names.flatMap((name) => {
    const work = readWork(storage.getItem(name) ?? '');
    return work ? [{ name, work }] : [];
  });
}

/** Of one tab; `place` is the storage that it shares with others. */
export function createStored(place: () => Storage = () => localStorage) {
  const me = Math.random().toString(36).slice(2, 12);
  /** By name: what this tab read or wrote there last. */
  const seen = new Map<string, string | null>();
  const withMe = (work: Work) => JSON.stringify({ ...JSON.parse(jsonOf(work)), by: me });

  /** Nothing where the browser keeps nothing. */
  function quietly<Result>(act: (storage: Storage) => Result, otherwise: Result): Result {
    try {
      return act(place());
    } catch {
      return otherwise;
    }
  }
  function note(storage: Storage, name: string) {
    seen.set(name, storage.getItem(keyOf(name)));
  }
  /** Where there is no room for what another tab wrote, nothing is overwritten. */
  function write(storage: Storage, name: string, work: Work): string {
    const there = storage.getItem(keyOf(name));
    const isOthers = there !== null && there !== seen.get(name);
    if (isOthers && readWork(there)?.text !== work.text) putAside(storage, name, there);
    const json = withMe(work);
    storage.setItem(keyOf(name), json);
    seen.set(name, json);
    return json;
  }
  return {
    /** What was written last, or last in that language; null for nothing. It is what this tab goes on from. */
    load: (id?: string) =>
      quietly((storage) => {
        const work = readWork(storage.getItem(id ? keyOf(id) : key) ?? '');
        if (work) note(storage, work.language.id);
        note(storage, before);
        return work;
      }, null),
    /** Whether it could be kept; a page from a disk may have no storage. What another tab wrote is kept, too. */
    keep: (work: Work) =>
      quietly((storage) => {
        storage.setItem(key, write(storage, work.language.id, work));
        return true;
      }, false),
    /** Keeps what stood there before something else is written. */
    keepBefore: (work: Work) => quietly((storage) => void write(storage, before, work), undefined),
    others: () => quietly(othersIn, []),
    forget: ({ name }: Other) => quietly((storage) => storage.removeItem(name), undefined),
    /** Calls when the program of this tab was overwritten by another tab, after it was kept under the id of this one. */
    onOverwritten: (listener: () => void) =>
      window.addEventListener('storage', ({ key: changed, oldValue, newValue }) => {
        if (!changed?.startsWith(keyOf('')) || oldValue === null || newValue === null) return;
        if (writerOf(oldValue) !== me || writerOf(newValue) === me || changed.startsWith(asideKey)) return;
        quietly((storage) => putAside(storage, changed.slice(keyOf('').length), oldValue), undefined);
        listener();
      }),
  };
}
