// The core as a WebAssembly module, without a loader of anybody else's: text and bytes in, text and bytes out.
import type { Failure } from './types';

interface Exports {
  memory: WebAssembly.Memory;
  _initialize?: () => void;
  /** Room for that many bytes of a part: 0 the name of the call, 1 the request, 2 what goes beside it. */
  labmouse_room: (part: number, size: number) => number;
  labmouse_call: () => void;
  labmouse_answer: () => number;
  labmouse_answer_size: () => number;
  labmouse_answer_bytes: () => number;
  labmouse_answer_bytes_size: () => number;
}

export interface Reply {
  answer?: Record<string, unknown>;
  failure?: Failure;
}

/** What the core's C++ library asks of a system; a strategy asks for nothing of it. */
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

  const get = (place: number, size: number) => new Uint8Array(exports.memory.buffer, place, size);
  return (name, request, bytes = new Uint8Array()) => {
    const text = (of: string) => new TextEncoder().encode(of);
    for (const [i, part] of [text(name), text(JSON.stringify(request)), bytes].entries()) {
      const place = exports.labmouse_room(i, part.length);
      new Uint8Array(exports.memory.buffer).set(part, place);
    }
    exports.labmouse_call();
    const reply = JSON.parse(new TextDecoder().decode(get(exports.labmouse_answer(), exports.labmouse_answer_size())));
    const size = exports.labmouse_answer_bytes_size();
    if (reply.answer && size > 0) reply.answer.bytes = get(exports.labmouse_answer_bytes(), size).slice();
    return reply;
  };
}
