// The worker in which the core runs, so that the page stays quick.
import packed from 'virtual:core';
import { startModule } from './module';
import { unpack } from './unpack';

const started = unpack(packed).then(startModule);

self.onmessage = async ({ data }: MessageEvent<{ id: number; name: string; request: unknown; bytes?: Uint8Array }>) => {
  try {
    const call = await started;
    self.postMessage({ id: data.id, ...call(data.name, data.request, data.bytes) });
  } catch (error) {
    self.postMessage({ id: data.id, failure: { error: `the core failed: ${String(error)}`, problems: [] } });
  }
};
