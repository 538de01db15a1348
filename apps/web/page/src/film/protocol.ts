// What the page and the worker that makes films say to each other: one order, one answer.

export type FilmOrder =
  /** `samples`: pixels of some frames, from which the colours are chosen. */
  | { kind: 'begin'; width: number; height: number; samples: Uint8ClampedArray }
  /** `delay`: for how many milliseconds it is seen. */
  | { kind: 'frame'; pixels: Uint8ClampedArray; delay: number }
  | { kind: 'end' };

export type FilmAnswer =
  /** `bytes` so far. */
  { kind: 'done'; bytes: number } | { kind: 'film'; film: Uint8Array<ArrayBuffer> };
