// A race that runs on the home page: two lanes, one clock, the gap.
import type { Core } from '../core/client';
import { count, createMeter } from '../player/meter';
import { partingOf } from '../player/parting';
import { h } from '../ui/dom';
import { gapInWords } from './gap';
import { createLane, type Lane } from './lane';
import { paceAt } from './pace';
import type { Met } from './pairs';

/** Seconds for which the end is shown before the next race. */
const rest = 5;
/** Of the contest, for which one sees them go the same way before they part. */
const lead = 10;
/** Of a clock that nothing has set: as high as one that is. */
const unset = '\u00a0';

const say = (place: HTMLElement, text: string) => place.textContent !== text && (place.textContent = text);

/** What stands above the lanes: the gap, the clock and the controls. */
function createBoard(controls: HTMLElement[]) {
  const clock = h('span.clock', { role: 'timer', 'aria-live': 'off' }, unset);
  const pace = h('span.pace');
  const gap = h('p.gap');
  const row = h('p', clock, ' s ', pace);
  return {
    element: h('div.board', gap, row, h('span.controls', ...controls)),
    /** Shows that moment, and says at which speed it passes. */
    show([one, other]: Lane[], time: number): number {
      const speed = paceAt([one.track.drive!, other.track.drive!], time);
      say(clock, time.toFixed(2));
      say(pace, speed === 1 ? 'real time' : `${speed}× speed`);
      say(gap, gapInWords(one.standing(), other.standing()));
      return speed;
    },
  };
}

/** When a pair begins to be shown: a little before they part. */
function beginOf([{ play }, other]: [Met, Met], { track }: Lane): number {
  const parting = partingOf(play, other.play);
  return Math.max(0, (parting ? track.time[parting.frame] : 0) - lead);
}

/** `ended` hears when a race was shown to its end; the controls stand beside the clock. */
export function createFrontRace(ended: () => void, ...controls: HTMLElement[]) {
  const lanes = h('div.lanes');
  const meter = createMeter();
  const board = createBoard(controls);
  const element = Object.assign(h('div.front-race', board.element, lanes), { meter });
  let two: Lane[] = [];
  let time = 0;
  let end = 0;
  let past = 0;
  let last = -1;
  let asked = 0;

  function show() {
    for (const lane of two) lane.show(time);
    return board.show(two, time);
  }
  function frame(now: number) {
    const begin = performance.now();
    asked = requestAnimationFrame(frame);
    // A pause of the browser, as in another tab, is none of the race.
    const passed = last < 0 ? 0 : Math.min(now - last, 100) / 1000;
    last = now;
    if (time >= end) past += passed;
    const speed = show();
    time = Math.min(time + passed * speed, end);
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
    element,
    /** Puts two mice where they are after so many seconds, or shortly before they part: what comes before looks the same. */
    set(core: Core, pair: [Met, Met], from?: number) {
      for (const lane of two) lane.close();
      two = [createLane(core, pair[0], 'to-goal'), createLane(core, pair[1], 'route')];
      lanes.replaceChildren(...two.map((lane) => lane.element));
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
