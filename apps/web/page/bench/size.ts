// How large the built page is, part by part.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import python from 'virtual:python';

const text = readFileSync(resolve(__dirname, '../../../../build/page/labmouse.html'), 'utf8');

/** Bytes of a part that stands in the page as it is, once. */
function part(content: string): number {
  if (text.split(content).length !== 2)
    throw new Error(`the page was not built from these sources: ${content.slice(0, 40)} …`);
  return Buffer.byteLength(content);
}

/** Megabytes: of the whole file, and of what it has for Python, which is two packed texts. */
export const wholeSize = (): number => Buffer.byteLength(text) / 1e6;
export const pythonSize = (): number => (part(python.script) + part(python.wasm)) / 1e6;
export const size = (): number => wholeSize() - pythonSize();
