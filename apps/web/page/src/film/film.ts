// A contest as a film: frames are painted here and put together in a worker.
import FilmWorker from './worker?worker&inline';
import { framesFor, planFilm, type Piece } from './plan';
import type { FilmAnswer, FilmOrder } from './protocol';

export interface Scenes {
  width: number;
  height: number;
  paint(context: CanvasRenderingContext2D, time: number): void;
  /** On the clock of the contest. */
  end: number;
  inSteps: boolean;
  /** Speed runs, which pass slower than searches. */
  fast: Piece[];
  /** Of the largest maze. */
  cells: number;
}

export interface Film {
  gif: Uint8Array<ArrayBuffer>;
  frames: number;
  /** Whether frames were left out because of the size. */
  shortened: boolean;
}

/** Bytes; more is not sent by many mailers and chats. */
export const mostBytes = 5_000_000;
/** The last frame is seen for so many milliseconds. */
const lastDelay = 2500;
const samples = 4;

/** How the making ends that was stopped. */
export class FilmStopped extends Error {
  constructor() {
    super('stopped');
  }
}

/** Makes it; `progress` hears shares from 0 to 1, `wanted` is asked after each frame. */
export async function makeFilm(
  scenes: Scenes,
  progress: (share: number) => void,
  wanted: () => boolean,
): Promise<Film> {
  const worker = new FilmWorker();
  const ask = (order: FilmOrder, transfer: Transferable[] = []) =>
    new Promise<FilmAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<FilmAnswer>) => resolve(data);
      worker.onerror = (event) => reject(new Error(`The film could not be made: ${event.message}`));
      worker.postMessage(order, transfer);
    });
  const canvas = document.createElement('canvas');
  canvas.width = scenes.width;
  canvas.height = scenes.height;
  const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true })!;
  const pixelsAt = (time: number) => {
    scenes.paint(context, time);
    return context.getImageData(0, 0, scenes.width, scenes.height).data;
  };
  /** Null where it became too large. */
  async function attempt(most: number): Promise<Film | null> {
    const { times, delay } = planFilm(scenes.end, scenes.inSteps, most, scenes.fast);
    const chosen = Array.from({ length: samples }, (_, i) => pixelsAt((scenes.end * (i + 1)) / samples));
    const all = new Uint8ClampedArray(chosen.reduce((sum, one) => sum + one.length, 0));
    chosen.forEach((one, i) => all.set(one, i * chosen[0].length));
    await ask({ kind: 'begin', width: scenes.width, height: scenes.height, samples: all }, [all.buffer]);
    for (const [i, time] of times.entries()) {
      if (!wanted()) throw new FilmStopped();
      const pixels = pixelsAt(time);
      const isLast = i === times.length - 1;
      const answer = await ask({ kind: 'frame', pixels, delay: isLast ? lastDelay : delay }, [pixels.buffer]);
      progress((i + 1) / times.length);
      if (answer.kind === 'done' && answer.bytes > mostBytes) return null;
    }
    const answer = await ask({ kind: 'end' });
    if (answer.kind !== 'film') return null;
    return { gif: answer.film, frames: times.length, shortened: scenes.inSteps && times.length <= scenes.end };
  }
  try {
    for (let most = framesFor(scenes.cells); most >= 8; most >>= 1) {
      const film = await attempt(most);
      if (film) return film;
    }
    throw new Error('This contest is too large for a film. Save a picture of it instead.');
  } finally {
    worker.terminate();
  }
}
