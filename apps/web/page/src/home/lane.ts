// One of the two mice of the home page: its name, what it does, its best run, and what it knows and believes.
import type { Core } from '../core/client';
import type { Tone } from '../maze/palette';
import { fetchBeliefs } from '../player/beliefs';
import { followsRoute, runAt } from '../player/drive';
import { usualLayers, type Layers } from '../player/layers';
import { createScene } from '../player/scene';
import { prepare } from '../player/track';
import { h } from '../ui/dom';
import type { Met } from './pairs';

const doing = { search: 'searches', home: 'goes back to the start', speed: 'runs', laps: 'drives laps' };

export type Lane = ReturnType<typeof createLane>;

export function createLane(core: Core, { play }: Met, hue: Tone) {
  const track = prepare(play);
  // The map shows a search run; the colour of the way shows the speed of a run.
  const layers: Layers = { ...usualLayers, speed: false };
  const scene = createScene(track, layers, { hue, plan: true });
  const what = h('span.doing');
  const best = h('span.best');
  const element = h(
    'figure',
    { class: `lane ${hue}` },
    h('figcaption', h('strong', play.mouse), what, best),
    scene.stage.element,
  );
  // They are seen a moment later than the mouse, which does not wait for them.
  fetchBeliefs(core, track).then(scene.setBeliefs, () => undefined);
  const say = (place: HTMLElement, text: string) => place.textContent !== text && (place.textContent = text);
  const bestNow = () => track.score[scene.past.frame];
  return {
    element,
    name: play.mouse,
    track,
    standing: () => ({ name: play.mouse, best: bestNow(), left: scene.distanceOf(scene.cell()) }),
    /** Goes to that time, in seconds. */
    show(time: number) {
      const run = track.drive!.runs[runAt(track.drive!, time)];
      const runs = followsRoute(run);
      if (runs !== layers.speed) {
        layers.speed = runs;
        scene.repaint();
      }
      scene.show(time, true);
      say(what, run && time < track.time[track.last] ? doing[run.kind] : 'is done');
      say(best, Number.isNaN(bestNow()) ? 'no run yet' : `best run ${bestNow().toFixed(3)} s`);
    },
    /** What is seen, in words. */
    describe: () =>
      scene.stage.describe(`${play.mouse} in ${play.maze.name}: ${what.textContent}, ${best.textContent}`),
    close: () => scene.stage.close(),
  };
}
