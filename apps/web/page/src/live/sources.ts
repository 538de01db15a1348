// Where the bytes of a real robot come from: a serial port, a WebSocket of this computer, a file, or text.
import type { MazeData } from '../core/types';
import { askForFiles } from '../ui/pick';

const servedName = { served: 'labmouse live' } as const;
const everywhere = { serial: 'serial port', socket: 'WebSocket', file: 'file', text: 'pasted text' } as const;
export type SourceName = keyof (typeof servedName & typeof everywhere);

/** Whether `labmouse live --page` serves this page, with the lines of a robot beside it. */
export const isServed = () => document.querySelector('meta[name="labmouse-robot"]') !== null;
export const sourceNames = () => (isServed() ? { ...servedName, ...everywhere } : everywhere);

export const bauds = [9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600];

/** What hears a source. */
export interface Listener {
  bytes(piece: Uint8Array): void;
  /** It ends; with an error if it broke. */
  ended(error?: string): void;
}

/** An open source. */
export interface Source {
  close(): void;
  /** Sends a line to the robot; null if it cannot. */
  send: ((line: string) => void) | null;
}

/** The parts of the browser's serial ports that the page uses. */
export interface SerialPort {
  open(options: { baudRate: number }): Promise<void>;
  close(): Promise<void>;
  readable: ReadableStream<Uint8Array>;
}
type Ports = { serial?: { requestPort(): Promise<SerialPort> } };

/** Reads until the end or `close`; a port that breaks says so. */
export async function openSerial(baudRate: number, listener: Listener, ports = navigator as Ports): Promise<Source> {
  if (!ports.serial)
    throw new Error('This browser has no serial ports. Use Chrome or Edge, or labmouse live in a terminal.');
  const port = await ports.serial.requestPort();
  await port.open({ baudRate });
  const reader = port.readable.getReader();
  async function read() {
    let error: string | undefined;
    try {
      for (let next = await reader.read(); !next.done; next = await reader.read()) listener.bytes(next.value);
    } catch (broken) {
      error = `The serial port broke off: ${broken instanceof Error ? broken.message : String(broken)}`;
    }
    reader.releaseLock();
    await port.close().catch(() => undefined);
    listener.ended(error);
  }
  void read();
  return { close: () => void reader.cancel().catch(() => undefined), send: null };
}

/** What `labmouse live --page` says of the robot. */
export interface Served {
  maze?: MazeData;
  width?: number;
  height?: number;
  robot?: string;
}

/** Answers of the server that served the page. */
async function served(name: string, signal?: AbortSignal): Promise<Response> {
  const answer = await fetch(name, { signal }).catch(() => null);
  if (!answer?.ok) throw new Error('labmouse live no longer answers. Start it again and open its new link.');
  return answer;
}

export const servedBegin = async () => (await (await served('begin')).json()) as Served;

/** The lines that `labmouse live --page` has read, and those that it reads from now on. */
export async function openServed(listener: Listener): Promise<Source> {
  const stop = new AbortController();
  const { body } = await served('lines', stop.signal);
  const reader = body!.getReader();
  async function read() {
    let error: string | undefined;
    try {
      for (let next = await reader.read(); !next.done; next = await reader.read()) listener.bytes(next.value);
    } catch {
      if (!stop.signal.aborted) error = 'The connection to labmouse live broke off.';
    }
    listener.ended(error);
  }
  void read();
  return { close: () => stop.abort(), send: null };
}

/** Whether the policy of the page lets it connect there. */
export const isHere = (address: string) => /^ws:\/\/127\.0\.0\.1:\d{1,5}(\/[^\s]*)?$/.test(address);

export async function openSocket(address: string, listener: Listener): Promise<Source> {
  if (!isHere(address)) throw new Error('The address has to begin with ws://127.0.0.1: and a port.');
  const socket = new WebSocket(address);
  socket.binaryType = 'arraybuffer';
  const encoder = new TextEncoder();
  socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) =>
    listener.bytes(typeof data === 'string' ? encoder.encode(data) : new Uint8Array(data));
  let error: string | undefined;
  socket.onerror = () => void (error = `Nothing answers at ${address}, or the connection broke off.`);
  socket.onclose = () => listener.ended(error);
  return { close: () => socket.close(), send: (line) => socket.send(line) };
}

/** All bytes at once. The last line may lack its end. */
export function openBytes(bytes: Uint8Array, listener: Listener): Source {
  listener.bytes(bytes);
  if (bytes.length > 0 && bytes[bytes.length - 1] !== 10) listener.bytes(Uint8Array.of(10));
  listener.ended();
  return { close: () => undefined, send: null };
}

export const openText = (text: string, listener: Listener) => openBytes(new TextEncoder().encode(text), listener);

export const openFile = (listener: Listener) =>
  askForFiles(([file]) => {
    if (!file) return listener.ended();
    file.arrayBuffer().then(
      (content) => openBytes(new Uint8Array(content), listener),
      () => listener.ended(`${file.name} cannot be read.`),
    );
  });
