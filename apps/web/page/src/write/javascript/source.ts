// A program in JavaScript as the script of a worker.
import shim from './shim.js?raw';

/** The shim, and the line that begins the function with the program. */
const before = (isModule: boolean) =>
  `labmouse(${isModule ? 'async ' : ''}function (exports, require, module, __filename, __dirname) {\n`;

const shimLines = shim.split('\n').length;
export const linesBefore = shimLines;

const importLine = /^([ \t]*)import\s+(?:([^'"\n]*?)\s+from\s+)?(['"])([^'"\n]+)\3[ \t]*;?/gm;

/** `import x from 'm'` as `const x = require('m')`: what a worker's script cannot say. No line moves. */
export function withoutImports(program: string): string {
  return program.replace(importLine, (_, blank: string, names: string | undefined, _quote, module: string) => {
    const from = `require(${JSON.stringify(module)})`;
    if (names === undefined) return `${blank}${from};`;
    const [whole, star] = /^\*\s+as\s+(\S+)$/.exec(names) ?? [];
    return `${blank}const ${whole ? star : names.replace(/\s+as\s+/g, ': ')} = ${from};`;
  });
}

export function workerSource(program: string): string {
  const plain = withoutImports(program);
  const start = shim.replace('const linesBefore = 0;', `const linesBefore = ${shimLines};`).trimEnd();
  // The shim ends with a line end, in whose place the function begins.
  return `${start}\n${before(plain !== program)}${plain}\n});\n`;
}
