// What is on the stage, saved: as a picture of this moment, or as a film of the whole contest.
import { makeFilm, mostBytes } from '../film/film';
import type { Piece } from '../film/plan';
import { fit, numbered } from '../maze/geometry';
import { readPalette } from '../maze/palette';
import { pngOf as pixelsOf } from '../maze/saved';
import { followsRoute } from './drive';
import { createSheet, timeText, type Pictured } from './sheet';
import type { Side, State } from './state';

/** Device pixels to a pixel of the page, in a picture; and the side of a maze of a film. */
const pictureRatio = 2;
const filmSide = 420;

/** Letters, digits, - and _ of mice and maze, for a file's name. */
export function fileName(sides: Side[], ending: string): string {
  const plain = (text: string) =>
    text
      .replace(/[^\w-]+/g, '-')
      .replace(/^-+|-+$/g, '')
      .slice(0, 60);
  return `${[...sides.map(({ track }) => plain(track.play.mouse)), plain(sides[0].track.maze.name)].join('-')}.${ending}`;
}

/** As it lies on the stage, a closer look included. */
function asSeen({ track, name, hue, scene }: Side): Pictured {
  const g = scene.stage.geometry();
  const by = pictureRatio / g.ratio;
  // A whole number of pixels to a cell, here too.
  const pitch = Math.round(g.pitch * by);
  const more = pitch / g.pitch;
  const px = (length: number) => Math.round(length * more);
  const geometry = {
    ...g,
    pitch,
    wall: Math.max(1, px(g.wall)),
    left: px(g.left),
    top: px(g.top),
    canvasWidth: px(g.canvasWidth),
    canvasHeight: px(g.canvasHeight),
    ratio: g.ratio * more,
  };
  return { track, name, hue, beliefs: scene.beliefs(), geometry };
}

const speedRuns = ({ track }: Side) =>
  (track.drive?.runs ?? []).filter(followsRoute).map(({ begin, end }): Piece => [begin / 1e6, end / 1e6]);

const asFilmed = ({ track, name, hue, scene }: Side): Pictured => ({
  track,
  name,
  hue,
  beliefs: scene.beliefs(),
  geometry: fit(track.maze, filmSide, filmSide, 1, numbered),
});

const sheetOf = ({ sides, layers }: State) => createSheet(sides.map(asSeen), layers, readPalette());

export function pngOf(state: State): Promise<Uint8Array<ArrayBuffer>> {
  const { width: canvasWidth, height: canvasHeight, paint } = sheetOf(state);
  return pixelsOf({ canvasWidth, canvasHeight, ratio: 1 }, (context) => paint(context, state.clock.time));
}

export const svgOf = (state: State): string => sheetOf(state).svg(state.clock.time);

/** The whole contest as a GIF, and what is to be said of it. `report` hears of the share that is done. */
export async function filmOf(
  { sides, layers, clock: { end } }: State,
  report: (share: number) => void,
  wanted: () => boolean,
): Promise<{ gif: Uint8Array<ArrayBuffer>; words: string }> {
  const { width, height, paint } = createSheet(sides.map(asFilmed), { ...layers }, readPalette());
  const inSteps = sides.every((side) => side.track.play.traits.clock === 'steps');
  const cells = Math.max(...sides.map((side) => side.track.cells));
  const plan = { width, height, paint, end, inSteps, fast: sides.flatMap(speedRuns), cells };
  const { gif, frames, shortened } = await makeFilm(plan, report, wanted);
  const size = `${(gif.length / 1e6).toFixed(1)} MB, ${frames} frames to ${timeText(sides[0].track, end)}`;
  const less = shortened ? `; steps are left out, to stay below ${mostBytes / 1e6} MB` : '';
  return { gif, words: `The film is saved: ${size}${less}.` };
}
