// What is painted on a canvas of its own size, as a file: in pixels, or as a drawing.
import { SvgContext } from './svg-context';
import type { Geometry } from './geometry';
import type { Context } from './painter';

type Size = Pick<Geometry, 'canvasWidth' | 'canvasHeight' | 'ratio'>;

export async function pngOf(
  { canvasWidth: width, canvasHeight: height }: Size,
  paint: (context: CanvasRenderingContext2D) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  paint(canvas.getContext('2d', { alpha: false })!);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!blob) throw new Error('This browser could not make the picture. Make the window smaller, and try again.');
  return new Uint8Array(await blob.arrayBuffer());
}

export function svgOf(
  { canvasWidth: width, canvasHeight: height, ratio }: Size,
  paint: (context: Context) => void,
): string {
  const drawn = new SvgContext();
  paint(drawn.asContext());
  const box = `width="${width / ratio}" height="${height / ratio}" viewBox="0 0 ${width} ${height}"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${box}>\n${drawn.elements()}\n</svg>\n`;
}

/** What paints a file, and its size. */
export interface Picture {
  g: Size;
  paint: (context: Context) => void;
}

type Save = (fileName: string, content: string | Uint8Array<ArrayBuffer>, type: string) => void;

/** Saves it under that name, which gets the ending. */
export async function savePicture(save: Save, name: string, ending: 'png' | 'svg', { g, paint }: Picture) {
  if (ending === 'png') save(`${name}.png`, await pngOf(g, paint), 'image/png');
  else save(`${name}.svg`, svgOf(g, paint), 'image/svg+xml');
}
