// The core as a WebAssembly module, without a loader of anybody else's: text and bytes in, text and bytes out.
import type { Failure } from './types';

interface Exports {
  memory: WebAssembly.Memory;
  _initialize?: () => void;
  /** Room for a request of that many bytes, and for what goes beside it. */
  labmouse_request: (size: number) => number;
  labmouse_request_bytes: (size: number) => number;
  labmouse_answer: () => number;
  labmouse_answer_size: () => number;
  labmouse_answer_bytes: () => number;
  labmouse_answer_bytes_size: () => number;
  [call: `labmouse_${string}`]: (size: number) => number;
}

export interface Reply {
  answer?: Record<string, unknown>;
  failure?: Failure;
}

/** What the core's C++ library asks of a system; a mind asks for nothing of it. */
function system(memory: () => WebAssembly.Memory) {
  const badf = 8;
  const nosys = 52;
  return {
    clock_time_get(_clock: number, _precision: bigint, at: number) {
      new DataView(memory().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    environ_sizes_get(count: number, size: number) {
      const view = new DataView(memory().buffer);
      view.setUint32(count, 0, true);
      view.setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    proc_exit(code: number) {
      throw new Error(`the core ended with code ${code}`);
    },
    fd_write: () => badf,
    fd_read: () => badf,
    fd_seek: () => badf,
    fd_close: () => badf,
    other: () => nosys,
  };
}

/** Those of the exports that only hand over requests and answers. */
const handOver = /^(request|answer)(_|$)/;

const isCall = (exports: Exports, name: string) => !handOver.test(name) && Object.hasOwn(exports, `labmouse_${name}`);

export type Call = (name: string, request: unknown, bytes?: Uint8Array) => Reply;

/** Starts a core anew. */
export async function startModule(module: WebAssembly.Module): Promise<Call> {
  const known = system(() => exports.memory) as unknown as Record<string, WebAssembly.ImportValue>;
  const imports: WebAssembly.Imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module))
    (imports[from] ??= {})[name] = known[name] ?? known.other;
  const instance = await WebAssembly.instantiate(module, imports);
  const exports = instance.exports as unknown as Exports;
  exports._initialize?.();

  const put = (place: number, bytes: Uint8Array) => new Uint8Array(exports.memory.buffer).set(bytes, place);
  const get = (place: number, size: number) => new Uint8Array(exports.memory.buffer, place, size);
  return (name, request, bytes = new Uint8Array()) => {
    if (!isCall(exports, name)) return { failure: { error: `the core has no call '${name}'`, problems: [] } };
    const text = new TextEncoder().encode(JSON.stringify(request));
    put(exports.labmouse_request(text.length), text);
    put(exports.labmouse_request_bytes(bytes.length), bytes);
    exports[`labmouse_${name}`](0);
    const reply = JSON.parse(new TextDecoder().decode(get(exports.labmouse_answer(), exports.labmouse_answer_size())));
    const size = exports.labmouse_answer_bytes_size();
    if (reply.answer && size > 0) reply.answer.bytes = get(exports.labmouse_answer_bytes(), size).slice();
    return reply;
  };
}
