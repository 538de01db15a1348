import { describe, expect, it } from 'vitest';
import { has, layerNames, toggled, usualLayers, type Layers } from '../../src/player/layers';
import { heatLevel } from '../../src/player/paint/floor';
import { mms, steps } from './plays';

describe('layers', () => {
  it('are offered where a play has something for them', () => {
    const offered = (play: ReturnType<typeof steps>) => layerNames.filter((layer) => has(play, layer));
    expect(offered(steps())).toEqual(['walls', 'wrong', 'visits', 'distances', 'rays', 'search', 'speed', 'best']);
    expect(offered(mms())).toEqual(['walls', 'visits', 'distances', 'search', 'best', 'mms']);
    const reasons = [{ frame: 0, ground: '', candidates: [], chosen: -1, known: 0, hope: 0, price: 0 }];
    expect(offered(steps({ reasons }))).toContain('candidates');
  });

  it('go on and off by their keys', () => {
    expect(toggled(usualLayers, 'wrong', true)).toEqual({ wrong: true });
    expect(toggled({ ...usualLayers, wrong: true }, 'wrong', true)).toEqual({ wrong: false });
    expect(toggled(usualLayers, 'walls', true)).toEqual({ walls: 'whole' });
  });

  it('go round the distances, without beliefs where there are none', () => {
    const round = (believes: boolean) => {
      const layers: Layers = { ...usualLayers };
      return [0, 1, 2].map(() => Object.assign(layers, toggled(layers, 'distances', believes)).distances);
    };
    expect(round(true)).toEqual(['true', 'believed', 'none']);
    expect(round(false)).toEqual(['true', 'none', 'true']);
  });
});

describe('heat', () => {
  it('has levels from one visit to the most', () => {
    expect([0, 1, 2, 5, 10, 11].map((visits) => heatLevel(visits, 11, 6))).toEqual([0, 1, 1, 3, 5, 6]);
    expect([heatLevel(0, 2, 6), heatLevel(1, 1, 6), heatLevel(2, 2, 6)]).toEqual([0, 1, 6]);
  });
});
