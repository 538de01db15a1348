// One of the two mice of the home page: its name, what it does, its best run, and what it knows and believes.
import type { Core } from '../core/client';
import { StageRoom } from '../maze/stage';
import type { Tone } from '../maze/palette';
import { fetchBeliefs } from '../player/beliefs';
import { followsRoute, runAt } from '../player/drive';
import { usualLayers, type Layers } from '../player/layers';
import { createScene } from '../player/scene';
import { prepare } from '../player/track';
import type { Met } from './pairs';

const deeds = { search: 'searches', home: 'goes back to the start', speed: 'runs', laps: 'drives laps' };

export type Lane = ReturnType<typeof createLane>;

export function createLane(core: Core, { play }: Met, hue: Tone) {
  const track = prepare(play);
  // The map shows a search run; the colour of the way shows the speed of a run.
  const layers: Layers = { ...usualLayers, speed: false };
  const scene = createScene(track, layers, { hue, plan: true });
  // They are seen a moment later than the mouse, which does not wait for them.
  fetchBeliefs(core, track).then(scene.setBeliefs, () => undefined);
  let doing = '';
  const bestNow = () => track.score[scene.past.frame];
  const best = () => (Number.isNaN(bestNow()) ? 'no run yet' : `best run ${bestNow().toFixed(3)} s`);
  return {
    name: play.mouse,
    hue,
    track,
    stage: scene.stage,
    doing: () => doing,
    best,
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
      doing = run && time < track.time[track.last] ? deeds[run.kind] : 'is done';
    },
    /** What is seen, in words. */
    describe: () => scene.stage.describe(`${play.mouse} in ${play.maze.name}: ${doing}, ${best()}`),
  };
}

export const LaneFigure = ({ lane: { name, hue, stage, doing, best } }: { lane: Lane }) => (
  <figure class={`lane ${hue}`}>
    <figcaption>
      <strong>{name}</strong>
      <span class="doing">{doing()}</span>
      <span class="best">{best()}</span>
    </figcaption>
    <StageRoom stage={stage} />
  </figure>
);
