/** How long a program may be silent, in milliseconds of a page that runs. */
export type Patience = ReturnType<typeof createPatience>;

/** A piece counts no longer than this, however long a busy machine took for it. */
const piece = 50;

/** All pieces together last no longer than so many times the limit: the timers of a page in the background are slow. */
const mostTimes = 5;

/** Time in which a busy machine does not run the page is not counted against the program. */
export function createPatience(limit: number) {
  const began = performance.now();
  let left = limit;
  return {
    isLeft: () => left > 0 && performance.now() - began < mostTimes * limit,
    /** Waits for one piece, or until the function that it hands to `listen` is called. */
    async piece(listen: (arrived: () => void) => void) {
      const before = performance.now();
      const longest = Math.min(piece, left);
      let timer: ReturnType<typeof setTimeout> | undefined;
      await new Promise<void>((resolve) => {
        timer = setTimeout(resolve, longest);
        listen(resolve);
      });
      clearTimeout(timer);
      left -= Math.min(longest, performance.now() - before);
    },
  };
}
