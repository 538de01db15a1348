// No function of the page has more lines than fit on a screen.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';
import { expect, it } from 'vitest';

const mostLines = 59;

const root = fileURLToPath(new URL('../../src', import.meta.url));
const files = readdirSync(root, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));

function longFunctions(file: string): string[] {
  const source = ts.createSourceFile(file, readFileSync(join(root, file), 'utf8'), ts.ScriptTarget.Latest, true);
  const lineOf = (position: number) => source.getLineAndCharacterOfPosition(position).line;
  const found: string[] = [];
  function visit(node: ts.Node) {
    if (ts.isFunctionLike(node) && 'body' in node && node.body) {
      const name = [node, node.parent].map((one) => (one as ts.NamedDeclaration).name?.getText(source)).find(Boolean);
      if (lineOf(node.end) - lineOf(node.getStart(source)) >= mostLines) found.push(`${file} ${name ?? 'unnamed'}`);
    }
    ts.forEachChild(node, visit);
  }
  visit(source);
  return found;
}

it(`no function has more than ${mostLines} lines`, () => {
  expect(files.flatMap(longFunctions)).toEqual([]);
});
