// How deep calls may go. MicroPython's build keeps 32 KB for them, enough for 155 calls: too few for a search by recursion
// through a maze of 256 cells, where Python on the command line allows 1000.

/**
 * Bytes of the stack that MicroPython gets, and how many of them it may use: 288 calls. Chromium's stack for a worker ends
 * after 350 (measured in November 2026), and there an error is nothing that a robot could catch.
 */
const room = 512 * 1024;
const use = 60 * 1024;
/** Words of the stack on which MicroPython itself keeps the variables of calls. */
export const callWords = 32 * 1024;

interface Exports {
  memory: WebAssembly.Memory;
  malloc(size: number): number;
  _emscripten_stack_restore(place: number): void;
  emscripten_stack_get_current(): number;
}

const exportsOf = (instance: WebAssembly.Instance) => instance.exports as unknown as Exports;

/** Moves the stack of an instance that has not yet run to where it has room. */
export function roomForCalls(instance: WebAssembly.Instance): void {
  const { malloc, _emscripten_stack_restore } = exportsOf(instance);
  _emscripten_stack_restore((malloc(room) + room) & ~15);
}

/**
 * Tells a MicroPython that was started there how much it may use. Its state holds where the stack began and, beside it, the
 * limit; nothing it exports sets that. Where they are not found exactly once, the limit stays.
 */
export function deepen(instance: WebAssembly.Instance): void {
  const { memory, emscripten_stack_get_current } = exportsOf(instance);
  const top = emscripten_stack_get_current();
  const words = new Uint32Array(memory.buffer, 0, (top - room) >> 2);
  const found: number[] = [];
  for (let at = 0; at + 1 < words.length; ++at) {
    const isTop = words[at] > top - 256 && words[at] <= top;
    if (isTop && words[at + 1] >= 16 * 1024 && words[at + 1] <= 64 * 1024) found.push(at + 1);
  }
  if (found.length === 1) words[found[0]] = use;
}
