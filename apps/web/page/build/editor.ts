// The module `virtual:editor`: the editor as text that a script can hold. It is a library, so what the page does not use of
// it is left out, and it is packed: most visitors never write.
import { fileURLToPath } from 'node:url';
import { build, type Plugin, type Rollup } from 'vite';
import type { Later } from './one-file';
import { pack } from './pack';

const name = 'virtual:editor';
const entry = fileURLToPath(new URL('../src/write/editor/bundle.ts', import.meta.url));

let made: Promise<Later> | null = null;

/** The script as the page puts it in. */
export const editorScript = () => (made ??= bundle());

async function bundle(): Promise<Later> {
  const built = await build({
    configFile: false,
    logLevel: 'warn',
    build: {
      target: 'es2022',
      write: false,
      reportCompressedSize: false,
      lib: { entry, formats: ['iife'], name: 'labmouseEditor' },
    },
  });
  const [{ output }] = [built].flat() as Rollup.RollupOutput[];
  return { script: output[0].code.trim(), modules: output[0].moduleIds };
}

export function editor(): Plugin {
  return {
    name: 'labmouse-editor',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    async load(id) {
      if (id !== `\0${name}`) return null;
      return `export default ${JSON.stringify(await pack((await editorScript()).script))};`;
    },
  };
}
