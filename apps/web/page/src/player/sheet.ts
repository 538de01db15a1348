// What is on the stage as a picture: each maze below the name of its mouse, and the time below all.
import { fontOf } from '../maze/fonts';
import type { Geometry } from '../maze/geometry';
import { paintGround, type Context } from '../maze/painter';
import type { Palette, Tone } from '../maze/palette';
import { counted, decimal, mazeText } from './figures';
import type { Layers } from './layers';
import { createPlace, paintAbove, paintBelow } from './painting';
import { createPast, moveTo } from './past';
import { shareOf } from './scene';
import { SvgContext } from '../maze/svg-context';
import { frameAt, type Track } from './track';

/** One of the contests of a picture. */
export interface Pictured {
  track: Track;
  name: string;
  hue: Tone;
  beliefs: Uint16Array | null;
  /** How its maze lies on a canvas of its own. */
  geometry: Geometry;
}

/** In pixels of the page. */
const gap = 16;
const line = 22;
const size = 14;

/** The clock of a film and of a picture. */
export const timeText = (track: Track, time: number): string =>
  track.play.traits.clock === 'steps' ? counted(Math.floor(time), 'step') : `${decimal(time, 2)} s`;

/** Something that paints one play at any time, on the canvas that its geometry is of. */
function painterOf({ track, hue, beliefs, geometry: g }: Pictured, layers: Layers, palette: Palette) {
  const past = createPast(track);
  const place = createPlace(track);
  return (context: Context, time: number) => {
    const frame = frameAt(track, time);
    if (frame !== past.frame) moveTo(past, frame);
    // In seconds a mouse is between its frames; a step is done or not.
    place.look(time, frame, track.drive ? shareOf(track, frame, time) : 0);
    const brush = { context, g, palette, track, past, layers, beliefs, hue };
    paintBelow(brush);
    paintAbove(brush, place);
  };
}

/** Where each maze begins, with that gap around them, and where the sheet ends. */
function sideBySide(plays: Pictured[], between: number): [lefts: number[], width: number] {
  const lefts: number[] = [];
  let width = between;
  for (const { geometry } of plays) {
    lefts.push(width);
    width += geometry.canvasWidth + between;
  }
  return [lefts, width];
}

export function createSheet(plays: Pictured[], layers: Layers, palette: Palette) {
  const ratio = plays[0].geometry.ratio;
  const px = (length: number) => Math.round(length * ratio);
  const painters = plays.map((one) => painterOf(one, layers, palette));
  const canvases = plays.map(({ geometry: { canvasWidth: width, canvasHeight: height } }) => {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    return canvas.getContext('2d', { alpha: false })!;
  });
  const [lefts, width] = sideBySide(plays, px(gap));
  const top = px(line + gap / 2);
  const most = Math.max(...plays.map(({ geometry }) => geometry.canvasHeight));
  const height = top + most + px(line + gap / 2);

  function paintWords(context: Context, time: number) {
    paintGround(context, { ...plays[0].geometry, canvasWidth: width, canvasHeight: height }, palette);
    context.textAlign = 'left';
    context.textBaseline = 'alphabetic';
    plays.forEach(({ name, hue }, i) => {
      context.font = fontOf(palette, px(size), 600);
      context.fillStyle = palette[hue];
      context.fillText(name, lefts[i], px(line));
    });
    context.font = fontOf(palette, px(size), 600);
    context.fillStyle = palette.ink;
    context.fillText(timeText(plays[0].track, time), px(gap), height - px(gap / 2));
    context.font = fontOf(palette, px(size - 2));
    context.fillStyle = palette.muted;
    context.textAlign = 'right';
    const { maze } = plays[0].track;
    // Where there is no room for more, the name alone.
    const words = width > px(360) ? `${mazeText(maze)} · labmouse` : maze.name;
    context.fillText(words, width - px(gap), height - px(gap / 2));
  }
  return {
    /** Device pixels. */
    width,
    height,
    paint(context: CanvasRenderingContext2D, time: number) {
      paintWords(context, time);
      painters.forEach((paint, i) => {
        paint(canvases[i], time);
        context.drawImage(canvases[i].canvas, lefts[i], top);
      });
    },
    svg(time: number) {
      const words = new SvgContext();
      paintWords(words.asContext(), time);
      const mazes = painters.map((paint, i) => {
        const drawn = new SvgContext();
        paint(drawn.asContext(), time);
        const { canvasWidth, canvasHeight } = plays[i].geometry;
        // What a closer look leaves out is cut off by the inner picture's border.
        return `<svg x="${lefts[i]}" y="${top}" width="${canvasWidth}" height="${canvasHeight}">\n${drawn.elements()}\n</svg>`;
      });
      const box = `width="${width / ratio}" height="${height / ratio}" viewBox="0 0 ${width} ${height}"`;
      return `<svg xmlns="http://www.w3.org/2000/svg" ${box}>\n${words.elements()}\n${mazes.join('\n')}\n</svg>\n`;
    },
  };
}
