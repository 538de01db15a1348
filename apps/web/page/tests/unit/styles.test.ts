// The style sheets: sizes of type and room between things come from two scales, which page.css has.
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, it } from 'vitest';

const folder = resolve(__dirname, '../../src/styles');
/** All that is said of those properties, as `file: property: value`. */
const said = (properties: RegExp) =>
  readdirSync(folder).flatMap((file) =>
    [...readFileSync(join(folder, file), 'utf8').matchAll(/(?<=[{;\n]\s*)([a-z-]+): ([^;{}]+)(?=;)/g)]
      .filter(([, property]) => properties.test(property))
      .map(([, property, value]) => `${file}: ${property}: ${value}`),
  );
/** Those that have a length of their own; what is 0, or a share of something else, is none. */
const ownLengths = (list: string[]) =>
  list.filter((one) => /\d(px|rem|ch|vw|vh)\b/.test(one.replace(/(0px|-1px)\b/g, '')));

it('every size of type is of the scale', () => {
  const sizes = said(/^font-size$/);
  expect(sizes.length).toBeGreaterThan(40);
  expect(ownLengths(sizes)).toEqual([]);
});

it('all room between things is of the scale', () => {
  const rooms = said(/^((row-|column-)?gap|(padding|margin)(-.*)?)$/);
  expect(rooms.length).toBeGreaterThan(150);
  expect(ownLengths(rooms)).toEqual([]);
});

it('corners are as round everywhere', () => {
  expect(ownLengths(said(/radius$/))).toEqual([]);
});
