// The module `virtual:core`: the compiled core as text that a script can hold.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import type { Plugin } from 'vite';

const name = 'virtual:core';

/** Packs that WebAssembly file (gzip, base64), whenever somebody imports it. */
export function core(file: string): Plugin {
  return {
    name: 'labmouse-core',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      this.addWatchFile(file);
      const packed = gzipSync(readFileSync(file), { level: 9 }).toString('base64');
      return `export default ${JSON.stringify(packed)};`;
    },
  };
}
