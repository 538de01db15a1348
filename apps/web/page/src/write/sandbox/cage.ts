// Where programs run: workers inside of a sandboxed frame of opaque origin. They reach neither the page nor the network nor
// any storage, and whatever they do, they end with the frame.
import { hash, script } from 'virtual:frame';
import type { FromWorker, Language, ToWorker } from '../runtime';
import type { Patience } from './patience';

/** What a program says, and that it says too much. */
export type Said = FromWorker | { kind: 'flooded' };

/** One program that runs. */
export interface Session {
  say(words: ToWorker): void;
  /** The next thing that it says; null once no patience is left. */
  next(patience: Patience): Promise<Said | null>;
  end(): void;
}

export type Cage = ReturnType<typeof createCage>;

/** Nothing may load; a worker inherits this from the frame that starts it. The page's policy holds for both, too. */
const policy = (usesWasm: boolean) =>
  `default-src 'none'; script-src ${hash}${usesWasm ? " 'wasm-unsafe-eval'" : ''}; worker-src blob:`;

async function createFrame(usesWasm: boolean): Promise<HTMLIFrameElement> {
  const frame = document.createElement('iframe');
  frame.setAttribute('sandbox', 'allow-scripts');
  frame.title = 'Where programs run';
  frame.hidden = true;
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policy(usesWasm)}">`;
  frame.srcdoc = `<!doctype html><html lang="en"><head>${meta}<title>program</title></head><body><script>${script}</script></body></html>`;
  const loaded = new Promise((resolve) => frame.addEventListener('load', resolve, { once: true }));
  document.body.append(frame);
  await loaded;
  return frame;
}

function sessionOf(port: MessagePort): Session {
  const said: Said[] = [];
  let waiting: (() => void) | null = null;
  let ended = false;
  port.onmessage = ({ data }: MessageEvent<Said>) => {
    said.push(data);
    waiting?.();
  };
  return {
    say: (words) => port.postMessage(words),
    async next(patience) {
      while (said.length === 0 && !ended && patience.isLeft()) await patience.piece((arrived) => (waiting = arrived));
      waiting = null;
      return said.shift() ?? null;
    },
    end() {
      ended = true;
      port.postMessage(null);
      port.close();
      waiting?.();
    },
  };
}

export function createCage() {
  let frame: Promise<HTMLIFrameElement> | null = null;
  let allowsWasm = false;
  const sessions: Session[] = [];
  function close() {
    for (const session of sessions.splice(0)) session.end();
    void frame?.then((element) => element.remove());
    frame = null;
  }
  return {
    async start(language: Language, program: string) {
      if (frame && language.usesWasm !== allowsWasm) close();
      allowsWasm = language.usesWasm;
      frame ??= createFrame(allowsWasm);
      const [element, source] = await Promise.all([frame, language.workerSource(program)]);
      const { port1, port2 } = new MessageChannel();
      element.contentWindow?.postMessage({ source, linesBefore: language.linesBefore }, '*', [port2]);
      const session = sessionOf(port1);
      sessions.push(session);
      return session;
    },
    /** Ends all that runs in it. */
    close,
  };
}
