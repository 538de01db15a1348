// How many frames a film has and how long each is seen.

export interface FilmPlan {
  /** Times on the contest's clock. */
  times: number[];
  /** Milliseconds for each; GIFs count in hundredths of a second. */
  delay: number;
}

/** Of a maze of 16×16; larger ones have fewer, for each frame of theirs takes more room. */
const usualFrames = 360;
const usualCells = 256;
const leastFrames = 60;
/** Seconds of a whole film, and milliseconds of a frame at most. */
const length = 24;
const longest = 120;

/** How many frames a film in a maze of so many cells may have. */
export const framesFor = (cells: number): number =>
  Math.max(leastFrames, Math.round(usualFrames * Math.min(1, Math.sqrt(usualCells / cells))));

/** A piece of a contest, from one time to another on its clock. */
export type Piece = [from: number, to: number];

/** Speed runs take so many times the frames that a search of their length has. */
const slower = 4;

/** Those pieces in their order, none in another, within the contest. */
function apart(pieces: Piece[], end: number): Piece[] {
  const merged: Piece[] = [];
  for (const [from, to] of [...pieces].sort((a, b) => a[0] - b[0])) {
    const last = merged.at(-1);
    if (last && from <= last[1]) last[1] = Math.min(end, Math.max(last[1], to));
    else if (from < end) merged.push([from, Math.min(end, to)]);
  }
  return merged;
}

/** The time of the contest after that share of its film. */
function timeAt(share: number, end: number, fast: Piece[]): number {
  const extra = fast.reduce((sum, [from, to]) => sum + (slower - 1) * (to - from), 0);
  let shown = share * (end + extra);
  let time = 0;
  for (const [from, to] of fast) {
    if (shown <= from - time) return time + shown;
    shown -= from - time;
    if (shown <= slower * (to - from)) return from + shown / slower;
    shown -= slower * (to - from);
    time = to;
  }
  return Math.min(end, time + shown);
}

/** A film from the start to `end`. In steps no frame comes twice; `fast` pieces pass slower. The last frame is the end. */
export function planFilm(end: number, inSteps: boolean, most: number, fast: Piece[] = []): FilmPlan {
  const frames = Math.max(1, inSteps ? Math.min(most, Math.ceil(end)) : most);
  const pieces = inSteps ? [] : apart(fast, end);
  const times = Array.from({ length: frames + 1 }, (_, i) => {
    if (inSteps) return Math.round((end * i) / frames);
    return i === frames ? end : timeAt(i / frames, end, pieces);
  });
  const delay = Math.min(longest, Math.max(20, Math.round((length * 100) / frames) * 10));
  return { times, delay };
}
