// What a panel of the player is made from, without a canvas.
import { createClock } from '../../src/player/clock';
import { createMoment, goTo } from '../../src/player/drive';
import { usualLayers } from '../../src/player/layers';
import { createPast, moveTo } from '../../src/player/past';
import { frameAt, prepare } from '../../src/player/track';
import type { Actions, Side, State } from '../../src/player/state';
import type { Play } from '../../src/core/types';

/** A contest at that time. */
export function sideOf(play: Play, time = 0): Side {
  const track = prepare(play);
  const past = createPast(track);
  moveTo(past, frameAt(track, time));
  const moment = track.drive ? createMoment() : null;
  if (track.drive && moment) goTo(track.drive, time, moment);
  return { record: '{}', name: play.mouse, track, scene: { past, moment, track } } as unknown as Side;
}

export function stateOf(sides: Side[], time = 0): State {
  const end = Math.max(...sides.map(({ track }) => track.time[track.last]));
  return { clock: { ...createClock(), time, end }, layers: { ...usualLayers }, sides, chosen: 0, folded: false };
}

/** Actions that write down what they are asked. */
export function actionsOf(asked: unknown[][]): Actions {
  return new Proxy({} as Actions, {
    get:
      (_, name) =>
      (...what: unknown[]) =>
        void asked.push([name, ...what]),
  });
}
