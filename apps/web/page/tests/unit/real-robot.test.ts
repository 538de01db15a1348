// A real robot in the page: its sources by stand-ins, what is kept, and what is asked of the core.
import { afterEach, describe, expect, it, vi } from 'vitest';
import type { LiveState } from '../../src/core/types';
import { createRealRobot, mostFindings, type Wanted } from '../../src/live/real-robot';
import { unseenWalls } from '../../src/live/robot-map';
import { isHere, openSerial, openServed, openSocket, openText, type Listener } from '../../src/live/sources';
import { createCurve, createStreamLog, endOfLine } from '../../src/live/stream-log';
import type { Page } from '../../src/page/page';

const bytes = (text: string) => new TextEncoder().encode(text);
const text = (list: Uint8Array[]) => list.map((piece) => new TextDecoder().decode(piece)).join('');

/** Hears a source until it ends. */
function hearing() {
  const pieces: Uint8Array[] = [];
  let end!: (error?: string) => void;
  const ended = new Promise<string | undefined>((done) => (end = done));
  const listener: Listener = { bytes: (piece) => pieces.push(piece), ended: end };
  return { listener, pieces, ended };
}

/** A serial port that sends these pieces. With `breaks` it then breaks off; else it stays open. */
function port(pieces: string[], breaks = false) {
  const calls: unknown[] = [];
  const readable = new ReadableStream<Uint8Array>({
    start(control) {
      for (const piece of pieces) control.enqueue(bytes(piece));
    },
    pull(control) {
      if (breaks) control.error(new Error('pulled out'));
    },
  });
  const open = async (options: { baudRate: number }) => void calls.push(options);
  const close = async () => void calls.push('close');
  return { calls, serial: { requestPort: async () => ({ open, close, readable }) } };
}

class FakeSocket {
  static all: FakeSocket[] = [];
  onmessage?: (event: { data: unknown }) => void;
  onerror?: () => void;
  onclose?: () => void;
  sent: string[] = [];
  constructor(readonly address: string) {
    FakeSocket.all.push(this);
  }
  send = (line: string) => this.sent.push(line);
  close = () => this.onclose?.();
}

afterEach(() => void vi.unstubAllGlobals());

describe('a source', () => {
  it('is the program that served the page, until it is closed', async () => {
    const { listener, pieces, ended } = hearing();
    vi.stubGlobal('fetch', async (name: string, { signal }: { signal: AbortSignal }) => {
      expect(name).toBe('lines');
      const body = new ReadableStream<Uint8Array>({
        start(control) {
          control.enqueue(bytes('0 0 N 101\n'));
          signal.addEventListener('abort', () => control.error(signal.reason));
        },
      });
      return { ok: true, body };
    });
    const source = await openServed(listener);
    await vi.waitFor(() => expect(text(pieces)).toBe('0 0 N 101\n'));
    source.close();
    expect(await ended).toBeUndefined();
    vi.stubGlobal('fetch', async () => ({ ok: false }));
    await expect(openServed(listener)).rejects.toThrow('labmouse live');
  });
  it('is a serial port at its baud, until it is closed', async () => {
    const { listener, pieces, ended } = hearing();
    const { calls, serial } = port(['0 0 N', ' 101\n']);
    const source = await openSerial(9600, listener, { serial });
    await vi.waitFor(() => expect(text(pieces)).toBe('0 0 N 101\n'));
    source.close();
    expect(await ended).toBeUndefined();
    expect(calls).toEqual([{ baudRate: 9600 }, 'close']);
  });
  it('says that a serial port broke off, or that there are none', async () => {
    const { listener, ended } = hearing();
    await openSerial(115200, listener, port([], true));
    expect(await ended).toContain('pulled out');
    await expect(openSerial(115200, listener, {})).rejects.toThrow('labmouse live');
  });
  it('is a WebSocket of this computer, with text or bytes', async () => {
    vi.stubGlobal('WebSocket', FakeSocket);
    const { listener, pieces, ended } = hearing();
    const source = await openSocket('ws://127.0.0.1:8000/x', listener);
    const socket = FakeSocket.all.at(-1)!;
    socket.onmessage?.({ data: 'ab' });
    socket.onmessage?.({ data: bytes('cd').buffer });
    source.send!('plan S1\n');
    expect(text(pieces)).toBe('abcd');
    expect(socket.sent).toEqual(['plan S1\n']);
    socket.onerror?.();
    source.close();
    expect(await ended).toContain('ws://127.0.0.1:8000/x');
  });
  it('is nowhere else', async () => {
    for (const address of [
      'ws://example.org:80/',
      'wss://127.0.0.1:1/',
      'ws://127.0.0.1.example.org:1/',
      'ws://127.0.0.1/',
      'ws://localhost:1/',
    ]) {
      expect(isHere(address), address).toBe(false);
      await expect(openSocket(address, hearing().listener)).rejects.toThrow('127.0.0.1');
    }
  });
  it('is text, whose last line may lack its end', async () => {
    const { listener, pieces, ended } = hearing();
    openText('a\nb', listener);
    await ended;
    expect(text(pieces)).toBe('a\nb\n');
  });
});

describe('what is kept', () => {
  it('has limits after an hour of 200 lines a second', () => {
    const log = createStreamLog(1 << 20);
    const curve = createCurve(1000);
    const second = bytes('0 0 N 101 v=500 batt=7900\n'.repeat(200));
    for (let i = 0; i < 3600; ++i) {
      log.add(second);
      for (let k = 1; k <= 200; ++k) curve.add({ line: 200 * i + k, v: 1, batt: null });
    }
    expect(log.size()).toBeLessThanOrEqual(1 << 20);
    expect(log.isFull()).toBe(true);
    expect(curve.points().length).toBeLessThanOrEqual(1000);
    expect(curve.points().length).toBeGreaterThan(499);
    expect(curve.points()[0].line).toBe(1);
    // The whole time, evenly.
    const gaps = curve.points().flatMap(({ line }, i, all) => (i > 0 ? [line - all[i - 1].line] : []));
    expect(new Set(gaps).size).toBe(1);
    expect(curve.points().at(-1)!.line).toBeGreaterThan(715_000);
  });
  it('are the first lines, without a gap', () => {
    const log = createStreamLog(6);
    for (const piece of ['abcd', 'efgh', 'i']) log.add(bytes(piece));
    expect(text([log.bytes()])).toBe('abcd');
  });
  it('ends a line where the core ends it', () => {
    const lines = bytes('a\n\nb\r\nc');
    expect([0, 1, 2, 3, 4, 9].map((number) => endOfLine(lines, number))).toEqual([0, 2, 3, 6, 7, 7]);
  });
});

const empty: LiveState = {
  ...{ stream: 0, unseen: [], drawing: '', pose: null, route: [], fields: {}, values: [], findings: [] },
  ...{ contradictions: [], wrong: [], advice: '', plan: '', lines: 0, noise: 0, restarts: 0 },
  maze: { name: '', width: 2, height: 2, walls: [0, 0, 0, 0], start: [0, 0], heading: 'north', goals: [[1, 1]] },
};

/** A core that counts lines: each is a finding and a value. */
function counting() {
  const open = new Map<number, number>();
  const asked: [string, object][] = [];
  const saved: string[] = [];
  let last = 0;
  async function call(name: string, request: { stream?: number }, piece?: Uint8Array) {
    asked.push([name, request]);
    if (name === 'live_begin') {
      open.set(++last, 0);
      return { ...empty, stream: last };
    }
    const stream = request.stream!;
    if (name === 'live_end') return { ended: open.delete(stream) };
    const before = open.get(stream)!;
    const lines = before + piece!.filter((one) => one === 10).length;
    open.set(stream, lines);
    const numbers = Array.from({ length: lines - before }, (_, i) => before + 1 + i);
    return {
      ...{ ...empty, stream, lines },
      findings: numbers.map((line) => ({ kind: 'outside', line, cell: null, side: null, words: `line ${line}` })),
      values: numbers.map((line) => ({ line, v: line, batt: null })),
    };
  }
  const save = (_: string, content: Uint8Array) => void saved.push(text([content]));
  return { page: { core: { call }, save } as unknown as Page, open, asked, saved };
}

const wanted: Wanted = {
  ...{ source: 'text', baud: 0, address: '', text: '', robot: '', truth: null, width: 2, height: 2 },
};

describe('a real robot', () => {
  it('is read to its end, looked at again, and saved', async () => {
    const { page, open, saved } = counting();
    const robot = createRealRobot(page, () => undefined);
    const sent = 'line\n'.repeat(50_000);
    await robot.connect({ ...wanted, text: sent });
    await robot.settled();
    expect(robot.state).toMatchObject({ isOpen: false, error: '', now: { lines: 50_000 } });
    expect(robot.state.findings).toHaveLength(mostFindings);
    expect(robot.state.findings.at(-1)!.line).toBe(50_000);
    await robot.look(17);
    expect(robot.state.past?.lines).toBe(17);
    await robot.look(30_000);
    expect(robot.state.past?.lines).toBe(30_000);
    await robot.look(50_000);
    expect(robot.state.past).toBeNull();
    robot.save();
    expect(saved).toEqual([sent]);
    // Those of the past are ended, and so is this one with the next.
    expect(open.size).toBe(1);
    await robot.connect({ ...wanted, text: 'x' });
    await robot.settled();
    expect(robot.state.now?.lines).toBe(1);
    expect(open.size).toBe(1);
  });
  it('is in a known maze, with a robot whose routes are planned, or in one of that size', async () => {
    const { page, asked } = counting();
    const robot = createRealRobot(page, () => undefined);
    await robot.connect({ ...wanted, truth: empty.maze, robot: 'classic' });
    await robot.connect(wanted);
    const begins = asked.filter(([name]) => name === 'live_begin').map(([, request]) => request);
    expect(begins).toEqual([
      { maze: empty.maze, robot: 'classic', built_in: 'classic' },
      { width: 2, height: 2 },
    ]);
  });
  it('loses nothing that comes while the core works', async () => {
    vi.stubGlobal('WebSocket', FakeSocket);
    const { page, saved } = counting();
    const robot = createRealRobot(page, () => undefined);
    await robot.connect({ ...wanted, source: 'socket', address: 'ws://127.0.0.1:1/' });
    const sent = Array.from({ length: 500 }, (_, i) => `line ${i}\n`);
    for (const data of sent) FakeSocket.all.at(-1)!.onmessage?.({ data });
    await robot.settled();
    expect(robot.state).toMatchObject({ isOpen: true, now: { lines: 500 } });
    robot.save();
    expect(saved).toEqual([sent.join('')]);
    robot.disconnect();
    expect(robot.state.isOpen).toBe(false);
  });
  it('says why it cannot be reached', async () => {
    const robot = createRealRobot(counting().page, () => undefined);
    await robot.connect({ ...wanted, source: 'socket', address: 'ws://example.org:1/' });
    expect(robot.state).toMatchObject({ isOpen: false, error: expect.stringContaining('127.0.0.1') });
  });
});

it('unseen walls are those of lists over walls', () => {
  expect(unseenWalls({ ...empty, unseen: [3, 1, 2, 0] })).toEqual([0, 4, 1, 6]);
});
