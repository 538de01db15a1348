declare module 'virtual:micropython' {
  interface Options {
    heapsize: number;
    pystack: number;
    linebuffer: boolean;
    stdin: () => number | null;
    stdout: (bytes: Uint8Array) => void;
    stderr: (bytes: Uint8Array) => void;
    /** What goes to emscripten as it is. */
    module: {
      instantiateWasm: (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance) => void) => void;
      onRuntimeInitialized?: () => void;
    };
  }
  export interface MicroPython {
    FS: { mkdir(path: string): void; writeFile(path: string, text: string): void };
    globals: { get(name: string): unknown };
    runPython(code: string): unknown;
  }
  export function loadMicroPython(options: Options): Promise<MicroPython>;
}

declare module 'virtual:python' {
  const packed: { script: string; wasm: string };
  export default packed;
}
