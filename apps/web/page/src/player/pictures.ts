// What is on the stage, saved: as a picture of this moment, or as a film of the whole contest.
import { FilmStopped, makeFilm, mostBytes } from '../film/film';
import type { Piece } from '../film/plan';
import { fit, numbered } from '../maze/geometry';
import { readPalette } from '../maze/palette';
import { h } from '../ui/dom';
import type { Page } from '../views/view';
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

const fastRuns = ({ track }: Side) =>
  (track.drive?.runs ?? [])
    .filter(({ kind }) => kind === 'fast')
    .map(({ begin, end }): Piece => [begin / 1e6, end / 1e6]);

const asFilmed = ({ track, name, hue, scene }: Side): Pictured => ({
  track,
  name,
  hue,
  beliefs: scene.beliefs(),
  geometry: fit(track.maze, filmSide, filmSide, 1, numbered),
});

export function createPictures(page: Page, state: State): { buttons: HTMLElement[]; progress: HTMLElement } {
  const bar = h('progress', { max: 1, value: 0, 'aria-label': 'Progress of the film' });
  let wanted = true;
  const stop = h('button', { type: 'button', onclick: () => (wanted = false) }, 'Stop the film');
  const progress = h('div', { class: 'row filming', hidden: true }, bar, stop);

  const sheet = () => createSheet(state.sides.map(asSeen), state.layers, readPalette());
  async function savePng() {
    const { width, height, paint } = sheet();
    const canvas = h('canvas', { width, height });
    paint(canvas.getContext('2d', { alpha: false })!, state.clock.time);
    const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
    if (!blob) throw new Error('This browser could not make the picture. Make the window smaller, and try again.');
    page.save(fileName(state.sides, 'png'), new Uint8Array(await blob.arrayBuffer()), 'image/png');
  }
  async function saveSvg() {
    page.save(fileName(state.sides, 'svg'), sheet().svg(state.clock.time), 'image/svg+xml');
  }
  async function saveFilm() {
    const sides = [...state.sides];
    const { width, height, paint } = createSheet(sides.map(asFilmed), { ...state.layers }, readPalette());
    const [{ track }] = sides;
    wanted = true;
    bar.value = 0;
    progress.hidden = false;
    film.disabled = true;
    try {
      const made = await makeFilm(
        {
          width,
          height,
          paint,
          end: state.clock.end,
          inSteps: sides.every((side) => side.track.play.world === 'steps'),
          fast: sides.flatMap(fastRuns),
          cells: Math.max(...sides.map((side) => side.track.cells)),
        },
        (share) => (bar.value = share),
        () => wanted,
      );
      page.save(fileName(sides, 'gif'), made.gif, 'image/gif');
      const size = `${(made.gif.length / 1e6).toFixed(1)} MB, ${made.frames} frames to ${timeText(track, state.clock.end)}`;
      const less = made.shortened ? `; steps are left out, to stay below ${mostBytes / 1e6} MB` : '';
      page.tell(`The film is saved: ${size}${less}.`);
    } catch (error) {
      if (!(error instanceof FilmStopped)) throw error;
      page.tell('The film was stopped.');
    } finally {
      progress.hidden = true;
      film.disabled = false;
    }
  }
  const button = (label: string, title: string, act: () => Promise<void>) =>
    h('button', { type: 'button', title, onclick: () => void act().catch(page.complain) }, label);
  const film = button('Save film (GIF)', 'The whole contest, as it is played', saveFilm);
  return {
    buttons: [
      button('Save moment (PNG)', 'What is on the stage now, in pixels', savePng),
      button('Save moment (SVG)', 'What is on the stage now, as a drawing', saveSvg),
      film,
    ],
    progress,
  };
}
