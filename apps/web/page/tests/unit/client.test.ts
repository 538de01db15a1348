// The queue of calls to the core, with a worker that answers when the test says so.
import { describe, expect, it } from 'vitest';
import { CoreError, startCore, Stopped } from '../../src/core/client';

interface Posted {
  name: string;
  answer(reply: object): void;
}

function started() {
  const posted: Posted[] = [];
  const ended: number[] = [];
  let count = 0;
  const core = startCore(() => {
    const number = ++count;
    const worker = {
      onmessage: (_: object) => undefined,
      onerror: null,
      postMessage: ({ name }: { name: string }) =>
        posted.push({ name, answer: (reply) => worker.onmessage({ data: reply }) }),
      terminate: () => ended.push(number),
    };
    return worker as unknown as Worker;
  });
  return { core, posted, ended };
}

describe('calls to the core', () => {
  it('are answered one after the other, or refused in words', async () => {
    const { core, posted } = started();
    const first = core.call('signature', {});
    const second = core.call('speed', {}).catch((error) => error);
    expect(posted.map(({ name }) => name)).toEqual(['signature']);
    posted[0].answer({ answer: { signature: 'x' } });
    expect(await first).toEqual({ signature: 'x' });
    posted[1].answer({ failure: { error: 'no', problems: [] } });
    expect(await second).toBeInstanceOf(CoreError);
  });
  it('are stopped with the core that works on them, and those behind go to a new one', async () => {
    const { core, posted, ended } = started();
    const race = core.call('signature', {}).catch((error) => error);
    const about = core.call('speed', {});
    core.stop();
    expect(await race).toBeInstanceOf(Stopped);
    expect(ended).toEqual([1]);
    posted[1].answer({ answer: 'fast' });
    expect(await about).toBe('fast');
  });
  it('leave the queue where they had not begun, and the core goes on', async () => {
    const { core, posted, ended } = started();
    const first = core.call('signature', {});
    const second = core.call('speed', {}).catch((error) => error);
    core.stop('speed');
    core.stop('race');
    expect(await second).toBeInstanceOf(Stopped);
    posted[0].answer({ answer: 'done' });
    expect([await first, ended, posted.length]).toEqual(['done', [], 1]);
  });
});
