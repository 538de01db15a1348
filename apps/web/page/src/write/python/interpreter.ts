// MicroPython with nothing around it: no JavaScript, no network, no clock but its own, and bounds on its memory.
import { loadMicroPython, type MicroPython } from 'virtual:micropython';
import { callWords, deepen, roomForCalls } from './call-depth';

/**
 * Bytes of all that a robot holds, and of MicroPython itself. Its garbage counts until the step ends: only between steps
 * MicroPython collects it here.
 */
export const mostMemory = 256 * 1024 * 1024;

/** What MicroPython's modules `js` and `jsffi` are made of. A robot reaches the browser by none of them. */
const severed = {
  nothing: ['lookup_attr', 'has_attr', 'mp_js_random_u32'],
  refused: [
    ...['call0', 'call1', 'call2', 'calln', 'call0_kwarg', 'calln_kwarg', 'js_reflect_construct'],
    ...['store_attr', 'js_subscr_load', 'js_subscr_store', 'js_get_iter', 'js_iter_next'],
    ...['proxy_convert_mp_to_js_then_js_to_mp_obj_jsside', 'create_promise', 'js_get_error_info'],
    ...['proxy_convert_mp_to_js_then_js_to_js_then_js_to_mp_obj_jsside'],
    ...['js_then_resolve', 'js_then_reject', 'js_then_continue'],
  ],
};

function refuse(): never {
  throw new Error('a robot in the page has no JavaScript: its modules js and jsffi do nothing');
}

/** The imports of MicroPython without a way out, and with a bound on its memory. */
function tamed(imports: WebAssembly.Imports): WebAssembly.Imports {
  const env = { ...imports.env } as Record<string, (...given: number[]) => number>;
  for (const name of severed.nothing) env[name] = () => 0;
  for (const name of severed.refused) env[name] = refuse;
  const resize = env.emscripten_resize_heap;
  env.emscripten_resize_heap = (size) => (size > mostMemory ? 0 : resize(size));
  return { ...imports, env };
}

export interface Interpreter {
  /** Runs Python; a failure is thrown, with its traceback as the message. */
  run(code: string): void;
  /** A function that was defined so, from text to text. */
  call(name: string, text: string): string;
  write(path: string, text: string): void;
}

/** Starts a MicroPython of its own; `print` gets what it prints, byte by byte. */
export async function startInterpreter(wasm: BufferSource, print: (byte: number) => void): Promise<Interpreter> {
  let instance: WebAssembly.Instance | undefined;
  const out = (bytes: Uint8Array) => print(bytes[0]);
  const python: MicroPython = await loadMicroPython({
    heapsize: 1024 * 1024,
    pystack: callWords,
    linebuffer: false,
    stdin: () => null,
    stdout: out,
    stderr: out,
    module: {
      instantiateWasm(imports, done) {
        void WebAssembly.instantiate(wasm, tamed(imports)).then((made) => done((instance = made.instance)));
      },
      onRuntimeInitialized: () => instance && roomForCalls(instance),
    },
  });
  if (instance) deepen(instance);
  return {
    run: (code) => void python.runPython(code),
    call: (name, text) => (python.globals.get(name) as (text: string) => string)(text),
    write(path, text) {
      const folders = path.split('/').slice(1, -1);
      folders.forEach((_, at) => {
        try {
          python.FS.mkdir(`/${folders.slice(0, at + 1).join('/')}`);
        } catch {
          // It is there.
        }
      });
      python.FS.writeFile(path, text);
    },
  };
}
