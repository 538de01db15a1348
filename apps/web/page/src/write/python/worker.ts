// The worker of a robot in Python: a script that contains everything, in a frame that has nothing else.
import { unpack } from '../../core/unpack';
import type { FromWorker, ToWorker } from '../runtime';
import { startRobot, type Robot } from './robot';

/** MicroPython's WebAssembly, packed; it stands ahead of this script. */
declare const packedMicroPython: string;

const post = (message: FromWorker) => self.postMessage(message);
let robot: Promise<Robot> | undefined;

async function start(program: string): Promise<Robot> {
  const started = await startRobot(await unpack(packedMicroPython), program, post);
  post({ kind: 'ready' });
  return started;
}

self.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === 'start')
    robot = start(data.program).catch((error) => {
      post({ kind: 'failed', message: `Python did not start: ${error}`, line: null });
      return { hear: () => undefined };
    });
  else void robot?.then((one) => one.hear(data.line));
};
