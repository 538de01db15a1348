// What the browser keeps for the page until it is opened again. Where it keeps nothing (a private window, a file from the
// disk in some browsers) everything works without, and without a message.
import { clear, createStore, get, set, type UseStore } from 'idb-keyval';

/** What is kept is of this version; what another one kept is not read. */
const version = 1;
const keepingKey = 'labmouse-keep';
/** What begins so in the other storage, which answers at once, goes with the rest: programs that were written. */
export const besides = 'labmouse-write';

export type Shelf = ReturnType<typeof createShelf>;

function isOff(): boolean {
  try {
    return localStorage.getItem(keepingKey) === 'no';
  } catch {
    return false;
  }
}

export function createShelf() {
  let off = isOff();
  let store: UseStore | null = null;
  /** The browser may refuse in any step, and in words of its own. */
  async function quietly<Result>(act: (store: UseStore) => Promise<Result>, otherwise: Result): Promise<Result> {
    try {
      return await act((store ??= createStore('labmouse', 'kept')));
    } catch {
      return otherwise;
    }
  }
  async function empty() {
    try {
      for (const key of Object.keys(localStorage)) if (key.startsWith(besides)) localStorage.removeItem(key);
    } catch {
      // Then nothing lies there.
    }
    await quietly(clear, undefined);
  }
  return {
    /** Whether anything is to be kept. */
    keeps: () => !off,
    /** Off also empties it. */
    async setKeeps(keeps: boolean) {
      off = !keeps;
      try {
        if (keeps) localStorage.removeItem(keepingKey);
        else localStorage.setItem(keepingKey, 'no');
      } catch {
        // It holds until the page is closed.
      }
      if (!keeps) await empty();
    },
    empty,
    /** What lies there, whatever it may be; null for nothing. Who reads it checks it like a file. */
    async read(key: string) {
      if (off) return null;
      const found = await quietly((from) => get<{ version: number; value: unknown }>(key, from), undefined);
      return typeof found === 'object' && found?.version === version ? (found.value ?? null) : null;
    },
    /** Nothing is kept where that fails. */
    async write(key: string, value: unknown) {
      if (!off) await quietly((into) => set(key, { version, value }, into), undefined);
    },
  };
}
