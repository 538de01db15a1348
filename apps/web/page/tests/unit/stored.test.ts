// @vitest-environment happy-dom
// Programs that are kept while several tabs write.
import { beforeEach, expect, it } from 'vitest';
import { languages } from '../../src/write/languages';
import { createStored, kept } from '../../src/write/stored';

const [language, other] = languages;
const work = (text: string, of = language) => ({ language: of, name: text, text });
const texts = (stored: ReturnType<typeof createStored>) => stored.others().map((one) => one.work.text);

beforeEach(() => localStorage.clear());

it('a program is kept by its language, and the last one of all', () => {
  const tab = createStored();
  expect(tab.load()).toBeNull();
  expect(tab.keep(work('a'))).toBe(true);
  expect(tab.keep(work('b', other))).toBe(true);
  expect(kept()).toEqual(work('b', other));
  expect(createStored().load(language.id)).toEqual(work('a'));
  expect(texts(tab)).toEqual([]);
});

it('what another tab wrote meanwhile is kept beside, the latest of each tab once', () => {
  const [first, second] = [createStored(), createStored()];
  first.load();
  second.load();
  first.keep(work('of the first'));
  second.keep(work('of the second'));
  expect(texts(second)).toEqual(['of the first']);
  first.keep(work('more of the first'));
  second.keep(work('more of the second'));
  expect(texts(second).sort()).toEqual(['more of the first', 'of the second']);
  expect(kept()!.text).toBe('more of the second');
  second.forget(second.others()[0]);
  expect(texts(second)).toHaveLength(1);
});

it('going on with what another tab wrote keeps nothing beside', () => {
  createStored().keep(work('a'));
  const later = createStored();
  later.load();
  later.keep(work('a and more'));
  expect(texts(later)).toEqual([]);
});

it('a tab whose program is overwritten keeps it under a name of its own, and says so', () => {
  const tab = createStored();
  let told = 0;
  tab.onOverwritten(() => ++told);
  tab.keep(work('mine'));
  const name = Object.keys(localStorage).find((one) => one.endsWith(`-${language.id}`))!;
  const oldValue = localStorage.getItem(name);
  const second = createStored();
  second.load();
  second.keep(work('changed'));
  dispatchEvent(new StorageEvent('storage', { key: name, oldValue, newValue: localStorage.getItem(name) }));
  expect(told).toBe(1);
  expect(texts(tab)).toEqual(['mine']);
});

it('where there is no room for both, nothing is overwritten', () => {
  const [first, second] = [createStored(), createStored(() => full)];
  const full = new Proxy(localStorage, {
    get: (storage, name) =>
      name === 'setItem'
        ? (key: string, value: string) => {
            if (key.includes('-of-')) throw new Error('full');
            storage.setItem(key, value);
          }
        : Reflect.get(storage, name).bind(storage),
  });
  second.load();
  first.keep(work('mine'));
  expect(second.keep(work('other'))).toBe(false);
  expect(kept()!.text).toBe('mine');
});

it('what stood there before is kept beside, too, where another tab puts something in its place', () => {
  const [first, second] = [createStored(), createStored()];
  first.load();
  second.load();
  first.keepBefore(work('before of the first'));
  second.keepBefore(work('before of the second'));
  expect(kept('before')!.text).toBe('before of the second');
  expect(texts(second)).toEqual(['before of the first']);
});
