// One contest in the player: its names, its score as it ticks, its picture.
import { h } from '../ui/dom';
import type { Layers } from './layers';
import { createScene } from './scene';
import type { Side } from './state';
import { prepare } from './track';
import { decimal, mazeText, runText } from './words';
import type { Shown } from './player';

export function createSide({ play, record }: Shown, layers: Layers, tallest: () => number): Side {
  const track = prepare(play);
  const scene = createScene(track, layers, tallest);
  const digits = play.world === 'mms' ? 1 : 3;
  const score = document.createTextNode('');
  const run = document.createTextNode('');
  const steps = document.createTextNode('');
  const best = play.bound === null ? '' : `best possible ${decimal(play.bound, digits)}`;
  const element = h(
    'figure',
    { class: 'side' },
    h(
      'figcaption',
      {},
      h('h3', {}, play.mouse, h('small', {}, ` in ${mazeText(play.maze)}: `), play.ended ? play.outcome : 'the record breaks off'),
      h(
        'p',
        { class: 'ticker' },
        h('span', { class: 'score' }, score),
        h('span', {}, 'score so far'),
        best !== '' && h('span', {}, best),
        h('span', {}, steps, ` of ${track.last} steps, `, run),
      ),
    ),
    scene.stage.element,
  );
  const set = (node: Text, text: string) => node.data !== text && (node.data = text);
  return {
    record,
    track,
    scene,
    element,
    update() {
      const { frame } = scene.past;
      set(score, decimal(track.score[frame], digits));
      set(steps, String(frame));
      set(run, runText({ track, scene }));
    },
  };
}
