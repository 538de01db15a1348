// What the parts of a player may do to it.
import { seek, start } from './clock';
import { enlarge, panStage, zoomStage } from './looks';
import { nextTime, timeOf, type Actions, type State } from './state';

export interface Effects {
  /** The player, which fills the screen and folds its panel. */
  room(): HTMLElement;
  /** Shows what has changed, in the next frame of the browser. */
  wake(): void;
  /** The numbers and lists at once. */
  refresh(): void;
  /** Fetches what the mice believed. */
  believe(): void;
}

export function createActions(state: State, { room, wake, refresh, believe }: Effects): Actions {
  const { clock, layers } = state;
  const chosen = () => state.sides[state.chosen];
  const stage = () => chosen()?.scene.stage;
  /** Shows what the act has changed. */
  const waking =
    <Arguments extends unknown[]>(act: (...given: Arguments) => void) =>
    (...given: Arguments) => {
      act(...given);
      wake();
    };
  return {
    toggle: waking(() => {
      if (clock.playing) clock.playing = false;
      else start(clock);
    }),
    step: waking((by) => {
      clock.playing = false;
      for (let i = 0; i < Math.abs(by); ++i) seek(clock, nextTime(state.sides, clock.time, by > 0));
    }),
    seek: waking((time) => seek(clock, time)),
    jump: waking((mark) => {
      const time = timeOf(chosen(), mark);
      if (time !== null) seek(clock, mark === 'end' ? clock.end : time);
    }),
    setSpeed: waking((speed) => (clock.speed = speed)),
    setLoop: waking((loop) => (clock.loop = loop)),
    setLayers: waking((changes) => {
      Object.assign(layers, changes);
      for (const { scene } of state.sides) scene.repaint();
      if (layers.distances === 'believed') believe();
    }),
    choose: waking((side) => (state.chosen = side)),
    zoom: (by) => zoomStage(stage(), by),
    pan: (x, y) => panStage(stage(), x, y),
    fold() {
      state.folded = room().classList.toggle('folded');
      refresh();
    },
    enlarge: () => enlarge(room()),
  };
}
