// The core in its worker, as functions that promise. What takes long can be stopped: then the core is started anew.
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

/** How a call ends that was stopped. */
export class Stopped extends Error {
  constructor() {
    super('stopped');
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
  /** Stops the first call of that name, or the one that the core works on. Those behind it are answered. */
  stop(name?: CallName): void;
}

interface Waiting {
  name: CallName;
  request: unknown;
  bytes?: Uint8Array;
  resolve: (answer: never) => void;
  reject: (error: Error) => void;
}

interface Reply {
  answer?: unknown;
  failure?: Failure;
}

/** Milliseconds after which somebody may want to stop a call. */
const long = 1000;

/**
 * Starts the core; calls are answered in the order in which they were made. `busy` hears the name of a call that takes
 * long, and of null when it is over.
 */
export function startCore(start: () => Worker, busy: (name: CallName | null) => void = () => undefined): Core {
  /** The first is what the core works on. */
  const queue: Waiting[] = [];
  let worker = begin();
  let late: ReturnType<typeof setTimeout> | undefined;

  function begin() {
    const begun = start();
    begun.onmessage = ({ data }: MessageEvent<Reply>) => end(data);
    begun.onerror = (event) => {
      for (const one of queue.splice(0)) one.reject(new Error(`the core stopped: ${event.message}`));
      rest();
    };
    return begun;
  }
  function rest() {
    clearTimeout(late);
    busy(null);
  }
  function next() {
    rest();
    const [one] = queue;
    if (!one) return;
    late = setTimeout(() => busy(one.name), long);
    worker.postMessage({ name: one.name, request: one.request, bytes: one.bytes });
  }
  function end({ answer, failure }: Reply) {
    const one = queue.shift();
    if (failure) one?.reject(new CoreError(failure.error, failure.problems));
    else one?.resolve(answer as never);
    next();
  }
  return {
    call: (name, request, ...bytes) =>
      new Promise((resolve, reject) => {
        queue.push({ name, request, bytes: bytes[0], resolve, reject });
        if (queue.length === 1) next();
      }),
    stop(name) {
      const at = queue.findIndex((one) => name === undefined || one.name === name);
      if (at < 0) return;
      queue.splice(at, 1)[0].reject(new Stopped());
      if (at > 0) return;
      worker.terminate();
      worker = begin();
      next();
    },
  };
}
