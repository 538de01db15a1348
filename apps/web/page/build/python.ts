// The modules `virtual:micropython` and `virtual:python`: MicroPython's own loader, fit for a worker that has nothing but its
// script, and all that such a worker runs, as text that a script can hold.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { build, type Plugin } from 'vite';

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

const pack = (content: string | Uint8Array) => gzipSync(content, { level: 9 }).toString('base64');

/** The script of the worker, built by itself. */
async function workerScript(): Promise<string> {
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
  const [{ output }] = [built].flat() as { output: { code: string }[] }[];
  return output[0].code;
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
  let isInside = false;
  return {
    name: 'labmouse-python',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    async load(id) {
      if (id !== `\0${name}`) return null;
      isInside = true;
      const packed = { script: pack(await workerScript()), wasm: pack(readFileSync(wasmFile)) };
      return `export default ${JSON.stringify(packed)};`;
    },
    // Its licence has to go with it; the package that npm brings has none in it.
    transformIndexHtml(html) {
      const licence = readFileSync(`${folder}/MICROPYTHON-LICENSE`, 'utf8');
      return isInside ? html.replace('</body>', `<!-- MicroPython\n\n${licence}-->\n  </body>`) : html;
    },
  };
}
