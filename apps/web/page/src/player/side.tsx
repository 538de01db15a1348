// One contest in the player: its names, its score as it ticks, its picture.
import { render } from 'preact';
import type { Play } from '../core/types';
import { cellAt } from '../maze/geometry';
import { h } from '../ui/dom';
import { counted, decimal, sizeText } from './figures';
import type { Layers } from './layers';
import { createScene, type Scene, type SceneOptions } from './scene';
import type { Side } from './state';
import { prepare, scoreAt, type Track } from './track';
import { runText } from './words';

/** A contest, and its record as text, to be saved. */
export interface Shown {
  play: Play;
  record: string;
}

/** What is to be said of the cell under the pointer. */
function readout(track: Track, { stage, past, distanceOf }: Scene): HTMLElement {
  const element = h('p.readout', { 'aria-hidden': 'true' });
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

export function Caption({ name, track, scene }: Pick<Side, 'name' | 'track' | 'scene'>) {
  const { play, drive, maze, last } = track;
  const { digits, bound } = play.traits;
  const { frame } = scene.past;
  const value = track.score[frame];
  const shown = scene.moment ? scene.moment.time : scoreAt(track, frame);
  return (
    <>
      <h3>
        <span class="who">
          {name}
          <small>
            {' '}
            in {maze.name}
            <span class="size">{sizeText(maze)}</span>
          </small>
        </span>
        <small>: </small>
        {play.outcome}
      </h3>
      <p class="ticker">
        <span class="score">{shown === null ? '–' : decimal(shown, digits)}</span>
        <span>{drive ? 's on the clock' : frame < last ? 'score so far' : 'score'}</span>
        {drive && <span>{Number.isNaN(value) ? 'no run so far' : `best so far ${decimal(value)}`}</span>}
        {play.bound !== null && <span title={bound}>best possible {decimal(play.bound, digits)}</span>}
        <span>
          {frame} of {last} {drive ? 'moves' : 'steps'}, {runText({ track, scene })}
        </span>
      </p>
    </>
  );
}

export function createSide(
  { play, record }: Shown,
  name: string,
  layers: Layers,
  { looked, hue }: Pick<SceneOptions, 'looked' | 'hue'>,
): Side {
  const track = prepare(play);
  const scene = createScene(track, layers, { looked, hue });
  const caption = h('figcaption');
  const element = h('figure', { class: hue ? `side ${hue}` : 'side' }, caption, scene.stage.element);
  scene.stage.element.append(readout(track, scene));
  return {
    record,
    name,
    track,
    scene,
    hue: hue ?? 'ink',
    element,
    update: () => render(<Caption name={name} track={track} scene={scene} />, caption),
  };
}
