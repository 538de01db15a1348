// What the painters of layers are handed; made once a canvas and changed in place.
import type { Geometry } from '../../maze/geometry';
import type { Context } from '../../maze/painter';
import type { Palette, Tone } from '../../maze/palette';
import type { Layers } from '../layers';
import type { Past } from '../past';
import type { Track } from '../track';

export interface Brush {
  context: Context;
  g: Geometry;
  palette: Palette;
  track: Track;
  past: Past;
  layers: Layers;
  /** Believed distances, frame by frame; null while there are none. */
  beliefs: Uint16Array | null;
  /** The tone of the mouse, and of the way that it believes in. */
  hue: Tone;
}

/** Device pixels for a share of a cell, one at least. */
export const thick = (g: Geometry, share: number) => Math.max(1, Math.round(g.pitch * share));

/**
 * Calls with the ends of each run of places that are wanted. What lies in a row is painted at once: a maze of 64 by 64 has
 * eight thousand walls, and each piece costs as much as a long one.
 */
export function eachRun(count: number, wanted: (place: number) => boolean, act: (from: number, to: number) => void) {
  for (let from = 0; from < count; ++from) {
    const begin = from;
    while (from < count && wanted(from)) ++from;
    if (from > begin) act(begin, from);
  }
}
