// One contest in the player: its names, its score as it ticks, its picture.
import { useState } from 'preact/hooks';
import type { Cell, Play } from '../core/types';
import { cellAt } from '../maze/geometry';
import { StageRoom } from '../maze/stage';
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

/** What is to be said of that cell. */
function readingOf({ maze, drive }: Track, { past, distanceOf }: Scene, [x, y]: Cell): string {
  const index = y * maze.width + x;
  const distance = distanceOf(index);
  const way = distance < 0 ? '' : `, ${counted(distance, drive ? 'cell' : 'step')} to the goal`;
  return `(${x},${y}): ${counted(past.visits[index], 'visit')}${way}`;
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

export function Contest({ side: { name, track, scene, hue } }: { side: Side }) {
  const [pointed, point] = useState('');
  function read({ target, offsetX, offsetY }: PointerEvent) {
    const cell = target === scene.stage.canvas && cellAt(scene.stage.geometry(), offsetX, offsetY);
    point(cell ? readingOf(track, scene, cell) : '');
  }
  return (
    <figure class={hue === 'ink' ? 'side' : `side ${hue}`}>
      <figcaption>
        <Caption name={name} track={track} scene={scene} />
      </figcaption>
      <StageRoom stage={scene.stage} onPointerMove={read} onPointerLeave={() => point('')}>
        <p class="readout" aria-hidden="true">
          {pointed}
        </p>
      </StageRoom>
    </figure>
  );
}

export function createSide(
  { play, record }: Shown,
  name: string,
  layers: Layers,
  { looked, hue }: Pick<SceneOptions, 'looked' | 'hue'>,
): Side {
  const track = prepare(play);
  return { record, name, track, scene: createScene(track, layers, { looked, hue }), hue: hue ?? 'ink' };
}
