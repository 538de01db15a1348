// The module `virtual:frame`: the script of the frame in which programs run, and its hash.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { hash } from './one-file';

const name = 'virtual:frame';
const file = fileURLToPath(new URL('../src/write/sandbox/frame.js', import.meta.url));

export const frameScript = () => readFileSync(file, 'utf8');

export function frame(): Plugin {
  return {
    name: 'labmouse-frame',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      this.addWatchFile(file);
      const script = frameScript();
      return `export const script = ${JSON.stringify(script)};\nexport const hash = ${JSON.stringify(hash(script))};`;
    },
  };
}
