// Which layers are drawn. They are the same for all players and are kept from play to play.
import type { Play } from '../core/types';

export type WallMode = 'known' | 'whole';
export type DistanceMode = 'none' | 'true' | 'believed';

export interface Layers {
  walls: WallMode;
  wrong: boolean;
  visits: boolean;
  distances: DistanceMode;
  rays: boolean;
  search: boolean;
  speed: boolean;
  best: boolean;
  candidates: boolean;
  mms: boolean;
}

export type LayerName = keyof Layers;

/** In the order of the legend; the keys 1 to 9 and 0 are those of its lines. */
export const layerNames: LayerName[] = [
  ...(['walls', 'wrong', 'visits', 'distances', 'rays'] as const),
  ...(['search', 'speed', 'best', 'candidates', 'mms'] as const),
];

export const usualLayers: Readonly<Layers> = {
  walls: 'known',
  wrong: false,
  visits: true,
  distances: 'none',
  rays: true,
  search: false,
  speed: true,
  best: false,
  candidates: false,
  mms: true,
};

/** Whether a play has anything for that layer. */
export function has(play: Play, layer: LayerName): boolean {
  const { draws, runs } = play.traits;
  switch (layer) {
    case 'rays':
      return play.left.length > 0 || play.drive?.bodies !== undefined;
    case 'search':
      return !play.drive;
    case 'wrong':
      return !draws;
    case 'speed':
      return runs.length > 1;
    case 'candidates':
      return play.reasons.length > 0;
    case 'mms':
      return draws;
    case 'best':
      return play.route.length > 1 || (play.drive?.best.t.length ?? 0) > 1;
    default:
      return true;
  }
}

/** What the next press of a layer's key leads to. */
export function toggled(layers: Layers, layer: LayerName, believes: boolean): Partial<Layers> {
  if (layer === 'walls') return { walls: layers.walls === 'known' ? 'whole' : 'known' };
  if (layer !== 'distances') return { [layer]: !layers[layer] };
  if (layers.distances === 'none') return { distances: 'true' };
  return { distances: layers.distances === 'true' && believes ? 'believed' : 'none' };
}

export const isUsual = (layers: Layers) => layerNames.every((name) => layers[name] === usualLayers[name]);
