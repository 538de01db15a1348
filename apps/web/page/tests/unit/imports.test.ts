// The folders of the page import what the table in README.md allows, and imports form no circle.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const page = fileURLToPath(new URL('../..', import.meta.url));
const root = join(page, 'src');
const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
/** What a file imports from `src`, as paths without their ending. */
const pathsOf = (file: string) =>
  [...readFileSync(join(root, file), 'utf8').matchAll(/(?:from|import)\s*\(?\s*'(\.[^'?]+)/g)]
    .map(([, path]) => relative(root, join(root, dirname(file), path)))
    .filter((path) => !path.startsWith('..'));
const importsOf = (file: string) =>
  pathsOf(file).flatMap((path) => files.filter((one) => one === `${path}.ts` || one === `${path}.tsx`));
const folderOf = (path: string) => path.split('/')[0];

it('imports go in no circle', () => {
  const done = new Set<string>();
  const circles: string[] = [];
  function visit(file: string, way: string[]) {
    if (way.includes(file)) circles.push([...way.slice(way.indexOf(file)), file].join(' → '));
    if (done.has(file) || way.includes(file)) return;
    for (const next of importsOf(file)) visit(next, [...way, file]);
    done.add(file);
  }
  for (const file of files) visit(file, []);
  expect(circles).toEqual([]);
});

/** The lines of the table: each folder with the folders that it may import. */
const table = new Map(
  [...readFileSync(join(page, 'README.md'), 'utf8').matchAll(/^\| (\w+) \|[^|]*\|([^|]*)\|$/gm)]
    .filter(([, folder]) => folder !== 'folder')
    .map(([, folder, allowed]) => [folder, allowed.match(/\w+/g) ?? []] as const),
);

it('the table has every folder, each below those that it may import', () => {
  const folders = [...table.keys()];
  expect([...folders].sort()).toEqual(
    [...new Set(files.filter((file) => file.includes('/')).map(folderOf))].concat('styles').sort(),
  );
  const upwards = folders.flatMap((folder, i) =>
    table
      .get(folder)!
      .filter((one) => !folders.slice(0, i).includes(one))
      .map((one) => `${folder} → ${one}`),
  );
  expect(upwards).toEqual([]);
});

it('a folder imports what the table allows, and the table allows nothing that is not needed', () => {
  const imported = [...table.keys()].map((folder) => {
    const own = files.filter((file) => folderOf(file) === folder);
    return [folder, [...new Set(own.flatMap(pathsOf).map(folderOf))].filter((one) => one !== folder).sort()];
  });
  expect(imported).toEqual([...table].map(([folder, allowed]) => [folder, [...allowed].sort()]));
});
