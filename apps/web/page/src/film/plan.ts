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

/** A film from the start to `end`. In steps no frame comes twice; the last frame is always the end. */
export function planFilm(end: number, inSteps: boolean, most: number): FilmPlan {
  const frames = Math.max(1, inSteps ? Math.min(most, Math.ceil(end)) : most);
  const times = Array.from({ length: frames + 1 }, (_, i) => {
    const time = (end * i) / frames;
    return inSteps ? Math.round(time) : time;
  });
  const delay = Math.min(longest, Math.max(20, Math.round((length * 100) / frames) * 10));
  return { times, delay };
}
