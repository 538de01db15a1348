// The module `virtual:core`: the compiled core as text that a script can hold.
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';
import { pack } from './pack';

const name = 'virtual:core';

/** Packs that WebAssembly file (gzip, base64), whenever somebody imports it. */
export function core(file: string): Plugin {
  return {
    name: 'labmouse-core',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    async load(id) {
      if (id !== `\0${name}`) return null;
      this.addWatchFile(file);
      return `export default ${JSON.stringify(await pack(readFileSync(file)))};`;
    },
  };
}
