// Texts for canvases that are needed again and again, each made once.
import type { Palette } from './palette';

const fonts = new Map<number, string>();
let family = '';

/** The page's typeface in that size (device pixels) and weight, for `context.font`. */
export function fontOf(palette: Palette, size: number, weight = 400): string {
  if (family !== palette.family) fonts.clear();
  family = palette.family;
  const key = 1000 * size + weight;
  let font = fonts.get(key);
  if (font === undefined) fonts.set(key, (font = `${weight} ${size}px ${family}`));
  return font;
}

const numbers: string[] = [];

/** A whole number as text. */
export const textOf = (number: number) => (numbers[number] ??= String(number));
