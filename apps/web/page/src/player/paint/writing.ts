// Small writing in cells.
import { fontOf } from '../../maze/fonts';
import type { Brush } from './brush';

/** Sets font and colours for writing of that size (device pixels), with a rim of paper for `strokeText`. */
export function prepareWriting({ context, palette }: Brush, size: number) {
  context.font = fontOf(palette, size);
  context.fillStyle = palette.ink;
  context.strokeStyle = palette.paper;
  context.lineWidth = Math.max(2, Math.round(size * 0.25));
  context.lineJoin = 'round';
  context.textBaseline = 'middle';
}
