// One contest in the player: its names, its score as it ticks, its picture.
import { h } from '../ui/dom';
import { boundOf } from '../ui/terms';
import { cellAt } from '../maze/geometry';
import type { Play } from '../core/types';
import type { Layers } from './layers';
import { createScene, type Scene, type SceneOptions } from './scene';
import type { Side } from './state';
import { prepare, type Track, scoreAt } from './track';
import { counted, decimal, mazeText } from './figures';
import { runText } from './words';

/** A contest, and its record as text, to be saved. */
export interface Shown {
  play: Play;
  record: string;
}

/** What is to be said of the cell under the pointer. */
function readout(track: Track, { stage, past, distanceOf }: Scene): HTMLElement {
  const element = h('p', { class: 'readout', 'aria-hidden': 'true' });
  stage.canvas.addEventListener('pointermove', ({ offsetX, offsetY }) => {
    const cell = cellAt(stage.geometry(), offsetX, offsetY);
    if (!cell) return element.replaceChildren();
    const [x, y] = cell;
    const index = y * track.maze.width + x;
    const distance = distanceOf(index);
    const way = distance < 0 ? '' : `, ${counted(distance, track.drive ? 'cell' : 'step')} to the goal`;
    element.textContent = `(${x},${y}): ${counted(past.visits[index], 'visit')}${way}`;
  });
  stage.canvas.addEventListener('pointerleave', () => element.replaceChildren());
  return element;
}

export function createSide(
  { play, record }: Shown,
  name: string,
  layers: Layers,
  { looked, hue }: Pick<SceneOptions, 'looked' | 'hue'>,
): Side {
  const track = prepare(play);
  const scene = createScene(track, layers, { looked, hue });
  const digits = play.world === 'mms' ? 1 : 3;
  const score = document.createTextNode('');
  const best = document.createTextNode('');
  const run = document.createTextNode('');
  const steps = document.createTextNode('');
  const bound = play.bound === null ? '' : `best possible ${decimal(play.bound, digits)}`;
  const element = h(
    'figure',
    { class: hue ? `side ${hue}` : 'side' },
    h(
      'figcaption',
      {},
      h('h3', {}, name, h('small', {}, ` in ${mazeText(play.maze)}: `), play.outcome),
      h(
        'p',
        { class: 'ticker' },
        h('span', { class: 'score' }, score),
        h('span', {}, track.drive ? 's on the clock' : 'score so far'),
        track.drive && h('span', {}, best),
        bound !== '' && h('span', { title: boundOf(play.world) }, bound),
        h('span', {}, steps, ` of ${track.last} ${track.drive ? 'moves' : 'steps'}, `, run),
      ),
    ),
    scene.stage.element,
  );
  scene.stage.element.append(readout(track, scene));
  const set = (node: Text, text: string) => node.data !== text && (node.data = text);
  return {
    record,
    name,
    track,
    scene,
    hue: hue ?? 'ink',
    element,
    update() {
      const { frame } = scene.past;
      const value = track.score[frame];
      const shown = scene.moment ? scene.moment.time : scoreAt(track, frame);
      set(score, shown === null ? '–' : decimal(shown, digits));
      set(best, Number.isNaN(value) ? 'no run so far' : `best so far ${decimal(value)}`);
      set(steps, String(frame));
      set(run, runText({ track, scene }));
    },
  };
}
