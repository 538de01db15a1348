// A real robot: reads its source through the core, and keeps what the page shows.
import type { Calls, LiveFinding, LiveState, MazeData } from '../core/types';
import { errorText } from '../ui/format';
import type { Page } from '../page/page';
import {
  openFile,
  openSerial,
  openServed,
  openSocket,
  openText,
  type Listener,
  type Source,
  type SourceName,
} from './sources';
import { createCurve, createStreamLog, endOfLine } from './stream-log';

/** The newest findings that are listed. */
export const mostFindings = 100;
/** Bytes of a call, so that answers stay small. */
const pieceSize = 1 << 16;

type Begin = Calls['live_begin']['request'];

export interface Wanted {
  source: SourceName;
  baud: number;
  address: string;
  text: string;
  /** The robot whose routes are planned; empty for none. */
  robot: string;
  /** The maze in which the robot is; null for one that nobody knows, of that size. */
  truth: MazeData | null;
  width: number;
  height: number;
}

export type RealRobot = ReturnType<typeof createRealRobot>;

const beginOf = ({ robot, truth, width, height }: Wanted): Begin => ({
  ...(truth ? { maze: truth } : { width, height }),
  ...(robot && { robot, built_in: robot }),
});

function open(wanted: Wanted, listener: Listener): Promise<Source | null> {
  const { source, baud, address, text } = wanted;
  if (source === 'serial') return openSerial(baud, listener);
  if (source === 'served') return openServed(listener);
  if (source === 'socket') return openSocket(address, listener);
  if (source === 'text') return Promise.resolve(openText(text, listener));
  openFile(listener);
  return Promise.resolve(null);
}

/** What the robot believed after that many lines. */
async function stateAfter({ core }: Page, begin: Begin, bytes: Uint8Array, lines: number): Promise<LiveState> {
  let now = await core.call('live_begin', begin);
  const { stream } = now;
  const end = endOfLine(bytes, lines);
  for (let at = 0; at < end; at += pieceSize)
    now = await core.call('live_feed', { stream }, bytes.slice(at, Math.min(at + pieceSize, end)));
  await core.call('live_end', { stream });
  return now;
}

/** Takes the next bytes off, at most those of a call. */
function takePiece(waiting: Uint8Array[]): Uint8Array {
  const piece = new Uint8Array(pieceSize);
  let size = 0;
  while (waiting.length > 0 && size < pieceSize) {
    const part = waiting[0].subarray(0, pieceSize - size);
    piece.set(part, size);
    size += part.length;
    if (part.length < waiting[0].length) waiting[0] = waiting[0].subarray(part.length);
    else waiting.shift();
  }
  return piece.slice(0, size);
}

/** What is kept of a stream from its begin on. */
const freshStream = () => ({
  now: null as LiveState | null,
  /** A moment of the past, which is shown instead. */
  past: null as LiveState | null,
  findings: [] as LiveFinding[],
  curve: createCurve(),
  log: createStreamLog(),
});

/** Ends what was read before; a core that was started anew has forgotten it. */
const end = async ({ core }: Page, before: LiveState | null) =>
  before && core.call('live_end', { stream: before.stream }).catch(() => undefined);

/** Keeps a piece, and what the core says after it. */
function keep(state: ReturnType<typeof freshStream>, piece: Uint8Array, now: LiveState) {
  state.log.add(piece);
  state.now = now;
  for (const point of now.values) state.curve.add(point);
  state.findings = [...state.findings, ...now.findings].slice(-mostFindings);
}

/** Leaves out what comes from a source that is no longer read. */
function listenerOf(
  state: { now: LiveState | null; isOpen: boolean },
  stream: number,
  hear: (piece: Uint8Array, stream: number) => void,
  ended: Listener['ended'],
): Listener {
  const isRead = () => state.now?.stream === stream;
  return {
    bytes: (piece) => isRead() && hear(piece, stream),
    ended: (error) => isRead() && state.isOpen && ended(error),
  };
}

interface Shown extends ReturnType<typeof freshStream> {
  wanted: Wanted | null;
}

/** Shows what the robot believed after that line, or the newest again. */
function createLook(page: Page, state: Shown, changed: () => void, fail: (error: unknown) => void) {
  let asked = 0;
  return async function look(lines: number) {
    const number = ++asked;
    const { now, wanted, log } = state;
    if (!now || !wanted) return;
    const past = lines < now.lines ? await stateAfter(page, beginOf(wanted), log.bytes(), lines).catch(fail) : null;
    if (number !== asked || state.now?.stream !== now.stream) return;
    state.past = past ?? null;
    changed();
  };
}

/** `changed` hears of all changes. */
export function createRealRobot(page: Page, changed: () => void) {
  const state = { ...freshStream(), isOpen: false, error: '', wanted: null as Wanted | null };
  let source: Source | null = null;
  let waiting: Uint8Array[] = [];
  let feeding: Promise<void> | null = null;

  function stop(error = '') {
    const closing = source;
    source = null;
    Object.assign(state, { isOpen: false, error });
    closing?.close();
    changed();
  }
  function fail(error: unknown) {
    waiting = [];
    stop(errorText(error));
  }
  async function feed(stream: number) {
    while (waiting.length > 0) {
      const piece = takePiece(waiting);
      const now = await page.core.call('live_feed', { stream }, piece);
      if (state.now?.stream !== stream) return;
      keep(state, piece, now);
      changed();
    }
  }
  const hear = (piece: Uint8Array, stream: number) => {
    waiting.push(piece);
    feeding ??= feed(stream)
      .catch(fail)
      .finally(() => void (feeding = null));
  };
  return {
    state,
    async connect(wanted: Wanted) {
      source?.close();
      try {
        const now = await page.core.call('live_begin', beginOf(wanted));
        await end(page, state.now);
        waiting = [];
        await feeding;
        Object.assign(state, freshStream(), { now, wanted, isOpen: true, error: '' });
        changed();
        source = await open(wanted, listenerOf(state, now.stream, hear, stop));
        if (!state.isOpen) source = null;
      } catch (error) {
        fail(error);
      }
    },
    disconnect: () => stop(),
    fail,
    look: createLook(page, state, changed, fail),
    /** Waits until all that came is read. */
    settled: async () => void (await feeding),
    save: () => page.save('robot.log', state.log.bytes(), 'text/plain'),
  };
}
