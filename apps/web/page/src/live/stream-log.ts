// What came from a real robot, kept for the replay and for a file; and its curves. All of it has a limit.

/** In bytes. An hour of 200 lines of 40 bytes a second has 29 MB. */
export const mostBytes = 1 << 26;
/** Of each curve. Where more come, every second one goes. */
export const mostPoints = 4000;

export type StreamLog = ReturnType<typeof createStreamLog>;

/** The bytes so far, in pieces. After the limit no more are kept, so that the begin of the map stays. */
export function createStreamLog(limit = mostBytes) {
  const pieces: Uint8Array[] = [];
  let size = 0;
  let isFull = false;
  return {
    add(piece: Uint8Array) {
      isFull ||= size + piece.length > limit;
      if (isFull) return;
      pieces.push(piece);
      size += piece.length;
    },
    size: () => size,
    isFull: () => isFull,
    bytes() {
      const all = new Uint8Array(size);
      let at = 0;
      for (const piece of pieces) {
        all.set(piece, at);
        at += piece.length;
      }
      return all;
    },
  };
}

/** Where the line of that number ends, from 1; the end of all bytes if there are fewer. */
export function endOfLine(bytes: Uint8Array, number: number): number {
  let at = 0;
  for (let line = 0; line < number; ++line) {
    const end = bytes.indexOf(10, at);
    if (end < 0) return bytes.length;
    at = end + 1;
  }
  return at;
}

export interface Point {
  line: number;
  v: number | null;
  batt: number | null;
}

/** Points of curves over lines: the whole time, with fewer points where there are many. */
export function createCurve(most = mostPoints) {
  let points: Point[] = [];
  let every = 1;
  let seen = 0;
  return {
    add(point: Point) {
      if (seen++ % every === 0) points.push(point);
      if (points.length <= most) return;
      points = points.filter((_, i) => i % 2 === 0);
      every *= 2;
    },
    points: () => points,
  };
}
