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
