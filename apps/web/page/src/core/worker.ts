// The worker in which the core runs, so that the page stays quick.
import packed from 'virtual:core';
import { startModule } from './module';
import { unpack } from './unpack';

const compiled = unpack(packed).then((wasm) => WebAssembly.compile(wasm));
let started = compiled.then(startModule);

self.onmessage = async ({ data }: MessageEvent<{ name: string; request: unknown; bytes?: Uint8Array }>) => {
  try {
    const call = await started;
    self.postMessage(call(data.name, data.request, data.bytes));
  } catch (error) {
    // What a core leaves behind that stopped in the middle is worth nothing.
    started = compiled.then(startModule);
    const reason = error instanceof Error ? error.message : String(error);
    const failure = { error: `the core crashed on this request and was restarted (${reason})`, problems: [] };
    self.postMessage({ failure });
  }
};
