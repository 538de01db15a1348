// The one clock of a player: where it is, whether it runs, how fast.

/** Times the usual speed. */
export const speeds = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64];

/** The position of 1×. */
export const usualSpeed = speeds.indexOf(1);

/** Steps (or seconds of the other worlds) in a second at the usual speed. */
export const usual = { steps: 4, seconds: 1 };

/** Seconds for all of it, at the speed `fit`. */
const fitSeconds = 20;

export interface Clock {
  /** Steps, or seconds in the other worlds; from 0 to `end`. */
  time: number;
  end: number;
  playing: boolean;
  loop: boolean;
  /** A position in `speeds`; -1 to fit. */
  speed: number;
  /** Of the world, at the usual speed. */
  unit: number;
  /** When it ticked last, in milliseconds; negative before the first time. */
  ticked: number;
}

export const createClock = (): Clock => ({
  time: 0,
  end: 0,
  playing: false,
  loop: false,
  speed: usualSpeed,
  unit: usual.steps,
  ticked: -1,
});

/** Steps (or seconds of the other worlds) in a second. */
export function rateOf(clock: Clock): number {
  return clock.speed < 0 ? Math.max(clock.end / fitSeconds, clock.unit / 4) : speeds[clock.speed] * clock.unit;
}

/** Time passes up to `now`, in milliseconds. A pause of the browser (another tab) counts as one tenth of a second. */
export function tick(clock: Clock, now: number) {
  const passed = clock.ticked < 0 ? 0 : Math.min(now - clock.ticked, 100) / 1000;
  clock.ticked = now;
  if (!clock.playing) return;
  clock.time += passed * rateOf(clock);
  if (clock.time < clock.end) return;
  if (clock.loop && clock.end > 0) clock.time = 0;
  else {
    clock.time = clock.end;
    clock.playing = false;
  }
}

export function start(clock: Clock) {
  if (clock.time >= clock.end) clock.time = 0;
  clock.ticked = -1;
  clock.playing = clock.end > 0;
}

export function seek(clock: Clock, time: number) {
  clock.time = Math.min(Math.max(time, 0), clock.end);
}
