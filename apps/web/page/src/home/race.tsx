// A race that runs on the home page: two lanes, one clock, the gap.
import type { ComponentChildren } from 'preact';
import type { Core } from '../core/client';
import { count, createMeter } from '../player/meter';
import { partingOf } from '../player/parting';
import { gapInWords } from './gap';
import { createLane, LaneFigure, type Lane } from './lane';
import { paceAt } from './pace';
import type { Met } from './pairs';

/** Seconds for which the end is shown before the next race. */
const rest = 5;
/** Of the contest, for which one sees them go the same way before they part. */
const lead = 10;
/** Of a clock that nothing has set: as high as one that is. */
const unset = '\u00a0';

/** When a pair begins to be shown: a little before they part. */
function beginOf([{ play }, other]: [Met, Met], { track }: Lane): number {
  const parting = partingOf(play, other.play);
  return Math.max(0, (parting ? track.time[parting.frame] : 0) - lead);
}

export type FrontRace = ReturnType<typeof createFrontRace>;

/** `draw` is called after each moment, `ended` when a race was shown to its end. */
export function createFrontRace(draw: () => void, ended: () => void) {
  const meter = createMeter();
  let two: Lane[] = [];
  let time = 0;
  let end = 0;
  let past = 0;
  let last = -1;
  let asked = 0;

  const pace = () => paceAt([two[0].track.drive!, two[1].track.drive!], time);
  function show() {
    for (const lane of two) lane.show(time);
    draw();
  }
  function frame(now: number) {
    const begin = performance.now();
    asked = requestAnimationFrame(frame);
    // A pause of the browser, as in another tab, is none of the race.
    const passed = last < 0 ? 0 : Math.min(now - last, 100) / 1000;
    last = now;
    if (time >= end) past += passed;
    show();
    time = Math.min(time + passed * pace(), end);
    count(meter, performance.now() - begin);
    if (past < rest) return;
    pause();
    ended();
  }
  function pause() {
    cancelAnimationFrame(asked);
    asked = 0;
    if (two.length > 0) show();
    for (const lane of two) lane.describe();
  }
  return {
    meter,
    lanes: () => two,
    pace,
    /** Puts two mice where they are after so many seconds, or shortly before they part: what comes before looks the same. */
    set(core: Core, pair: [Met, Met], from?: number) {
      two = [createLane(core, pair[0], 'to-goal'), createLane(core, pair[1], 'route')];
      past = 0;
      end = Math.max(...two.map(({ track }) => track.time[track.last]));
      time = Math.min(from ?? beginOf(pair, two[0]), end);
      show();
      for (const lane of two) lane.describe();
    },
    run() {
      if (asked || two.length === 0) return;
      last = -1;
      asked = requestAnimationFrame(frame);
    },
    pause,
    isRunning: () => asked !== 0,
    /** Where the race is, in seconds. */
    time: () => time,
  };
}

const paceInWords = (speed: number) => (speed === 1 ? 'real time' : `${speed}× speed`);

/** The gap, the clock and the controls, above the lanes. */
export function Race({ race, children }: { race: FrontRace; children: ComponentChildren }) {
  const lanes = race.lanes();
  return (
    <div class="front-race" ref={(element) => void (element && Object.assign(element, { meter: race.meter }))}>
      <div class="board">
        <p class="gap">{lanes.length > 0 && gapInWords(lanes[0].standing(), lanes[1].standing())}</p>
        <p>
          <span class="clock" role="timer" aria-live="off">
            {lanes.length > 0 ? race.time().toFixed(2) : unset}
          </span>
          {' s '}
          <span class="pace">{lanes.length > 0 && paceInWords(race.pace())}</span>
        </p>
        <span class="controls">{children}</span>
      </div>
      <div class="lanes">
        {lanes.map((lane) => (
          <LaneFigure key={lane} lane={lane} />
        ))}
      </div>
    </div>
  );
}
