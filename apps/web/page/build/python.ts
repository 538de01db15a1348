// The modules `virtual:micropython` and `virtual:python`: MicroPython's own loader, fit for a worker that has nothing but its
// script, and all that such a worker runs, as text that a script can hold.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { build, type Plugin, type Rollup } from 'vite';
import { workerModules } from './notices';
import { pack } from './pack';

const folder = fileURLToPath(new URL('../src/write/python', import.meta.url));
const loaderFile = createRequire(import.meta.url).resolve(
  '@micropython/micropython-webassembly-pyscript/micropython.mjs',
);
export const wasmFile = loaderFile.replace(/mjs$/, 'wasm');

/** What is taken out of the loader, or put in; each stands there once. */
const changes: [from: string | RegExp, to: string][] = [
  // The program for a terminal under node.
  [/if\(globalThis\.loadMicroPython=loadMicroPython,.*?\}\(\)\}(?=class PyProxy)/s, ''],
  // It runs as in a worker everywhere, also in tests under node.
  [/ENVIRONMENT_IS_NODE=globalThis\.process[^;,]*?,/, 'ENVIRONMENT_IS_NODE=false,'],
  ['ENVIRONMENT_IS_WORKER=!!globalThis.WorkerGlobalScope', 'ENVIRONMENT_IS_WORKER=true'],
  [/if\(!globalThis\.window&&!globalThis\.WorkerGlobalScope\)throw new Error\("[^"]*"\);/, ''],
  [/if\(ENVIRONMENT_IS_NODE\)\{const\{createRequire.*?import\.meta\.url\)\}/, ''],
  ['_scriptName=import.meta.url', '_scriptName=""'],
  ['new URL("micropython.wasm",import.meta.url).href', '""'],
  // How it is compiled and what it can do outside, emscripten lets one choose.
  ['let Module={locateFile', 'let Module={...options.module,locateFile'],
];

function loader(): string {
  let text = readFileSync(loaderFile, 'utf8');
  for (const [from, to] of changes) {
    if (text.split(from).length !== 2) throw new Error(`MicroPython's loader has changed: ${from} is not there once`);
    text = text.replace(from, () => to);
  }
  return text;
}

/** The script of the worker, built by itself. MicroPython's loader is inside of it under a name that is no file's. */
async function workerScript(): Promise<{ script: string; modules: string[] }> {
  const built = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [micropython()],
    build: {
      target: 'es2022',
      write: false,
      lib: { entry: `${folder}/worker.ts`, formats: ['iife'], name: 'worker' },
      rollupOptions: { treeshake: false },
    },
  });
  const [{ output }] = [built].flat() as Rollup.RollupOutput[];
  return { script: output[0].code, modules: [loaderFile, ...output[0].moduleIds] };
}

/** MicroPython's loader as a module. */
export function micropython(): Plugin {
  const name = 'virtual:micropython';
  return {
    name: 'labmouse-micropython',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load: (id) => (id === `\0${name}` ? loader() : null),
  };
}

/** The worker's script and MicroPython, packed (gzip, base64). */
export function python(): Plugin {
  const name = 'virtual:python';
  return {
    name: 'labmouse-python',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    async load(id) {
      if (id !== `\0${name}`) return null;
      const { script, modules } = await workerScript();
      for (const module of modules) workerModules.add(module);
      const packed = { script: await pack(script), wasm: await pack(readFileSync(wasmFile)) };
      return `export default ${JSON.stringify(packed)};`;
    },
  };
}
