// Makes a GIF of frames as they come, so that the page stays lively.
import { applyPalette, GIFEncoder, quantize } from 'gifenc';
import type { FilmAnswer, FilmOrder } from './protocol';

/** One of 256 is for what has not changed. */
const mostColours = 255;

let gif = GIFEncoder();
let palette: number[][] = [];
let shape = { width: 0, height: 0 };
let before: Uint8Array | null = null;

/** What is as it was becomes transparent: long runs of one number take next to no room. */
function changes(now: Uint8Array): Uint8Array {
  if (!before) return now;
  const unchanged = palette.length - 1;
  const index = new Uint8Array(now.length);
  for (let i = 0; i < now.length; ++i) index[i] = now[i] === before[i] ? unchanged : now[i];
  return index;
}

function begin({ width, height, samples }: Extract<FilmOrder, { kind: 'begin' }>) {
  shape = { width, height };
  gif = GIFEncoder();
  before = null;
  const colours = quantize(samples, mostColours);
  palette = [...colours, [0, 0, 0]];
}

function add({ pixels, delay }: Extract<FilmOrder, { kind: 'frame' }>) {
  // The last colour is none of the picture's.
  const now = applyPalette(pixels, palette.slice(0, -1));
  const first = before === null;
  gif.writeFrame(changes(now), shape.width, shape.height, {
    ...(first && { palette }),
    delay,
    ...(!first && { transparent: true, transparentIndex: palette.length - 1, dispose: 1 }),
  });
  before = now;
}

const answer = (message: FilmAnswer, transfer: Transferable[] = []) => postMessage(message, { transfer });

onmessage = ({ data }: MessageEvent<FilmOrder>) => {
  if (data.kind === 'begin') begin(data);
  if (data.kind === 'frame') add(data);
  if (data.kind !== 'end') return answer({ kind: 'done', bytes: gif.bytesView().length });
  gif.finish();
  const film = gif.bytes();
  answer({ kind: 'film', film }, [film.buffer]);
};
