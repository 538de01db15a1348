// The core in its worker, as functions that promise.
import type { CallName, Calls, Failure, Problem } from './types';

/** What the core says of a bad input: a line for people, and where it is wrong. */
export class CoreError extends Error {
  constructor(
    message: string,
    readonly problems: Problem[],
  ) {
    super(message);
  }
}

type Rest<Name extends CallName> = Calls[Name] extends { bytes: Uint8Array }
  ? [bytes: Uint8Array]
  : Calls[Name] extends { bytes?: Uint8Array }
    ? [bytes?: Uint8Array]
    : [];

export interface Core {
  call<Name extends CallName>(
    name: Name,
    request: Calls[Name]['request'],
    ...bytes: Rest<Name>
  ): Promise<Calls[Name]['answer']>;
}

/** Starts the core; calls are answered in the order in which they were made. */
export function startCore(worker: Worker): Core {
  type Waiting = { resolve: (answer: never) => void; reject: (error: Error) => void };
  const waiting = new Map<number, Waiting>();
  let last = 0;
  const failAll = (message: string) => {
    for (const one of waiting.values()) one.reject(new Error(message));
    waiting.clear();
  };
  worker.onmessage = ({ data }: MessageEvent<{ id: number; answer?: unknown; failure?: Failure }>) => {
    const one = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.failure) one?.reject(new CoreError(data.failure.error, data.failure.problems));
    else one?.resolve(data.answer as never);
  };
  worker.onerror = (event) => failAll(`the core stopped: ${event.message}`);
  return {
    call(name, request, ...bytes) {
      const id = ++last;
      return new Promise((resolve, reject) => {
        waiting.set(id, { resolve, reject });
        worker.postMessage({ id, name, request, bytes: bytes[0] });
      });
    },
  };
}
