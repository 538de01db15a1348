// The layers as toggles, each with what its signs mean: the legend of the pictures.
import type { Play } from '../core/types';
import { h, type Child } from '../ui/dom';
import { has, layerNames, type DistanceMode, type LayerName, type Layers, type WallMode } from './layers';
import { sample, type Sample } from './samples';
import type { Actions, Panel, State } from './state';

const tints = '; if the cells are too small for numbers, a tone, stronger when nearer';

type Sign = [Sample, string];

/** What each layer's signs say; those of the walls and in mms depend on more. */
function signsOf(layer: LayerName, layers: Layers, world: Play['world'], most: number, fastest: number): Sign[] {
  const mms = world === 'mms';
  const unit = world === 'seconds' ? 'cells' : 'steps';
  switch (layer) {
    case 'walls':
      if (mms)
        return layers.walls === 'known'
          ? [
              ['drawn', 'wall that the program drew, and that exists'],
              ['unseen', 'wall that it has not drawn yet'],
            ]
          : [['walls', 'wall of the maze']];
      return layers.walls === 'known'
        ? [
            ['walls', 'wall that the mouse knows so far'],
            ['unknown', 'not known yet: open or closed'],
          ]
        : [
            ['walls', 'wall'],
            ['unseen', 'wall that the mouse does not know yet'],
          ];
    case 'wrong':
      return [['wrong', 'closed, but not known yet: assuming that unknown walls are open is wrong here']];
    case 'visits':
      return [['visits', most > 1 ? `1 to ${most} visits to a cell so far` : '1 visit to a cell']];
    case 'distances':
      if (layers.distances === 'believed')
        return [
          ['distances', `${unit} to the goal as the mouse believed, assuming that all unknown walls are open${tints}`],
        ];
      return [['distances', `${unit} to the goal, in the whole maze${tints}`]];
    case 'rays':
      return [['rays', 'open cells to the left, ahead and to the right, read before the next step']];
    case 'exploration':
      return mms
        ? [
            ['exploration', 'way to the goal'],
            ['onwards', 'way from there on'],
          ]
        : [
            ['exploration', 'path of the exploration to the goal'],
            ['onwards', 'its path from there on'],
          ];
    case 'speed':
      if (world === 'seconds')
        return [
          [
            'speeds',
            `its path in this run so far: 0 to ${fastest.toFixed(2)} m/s, in steps of ${(fastest / 6).toFixed(2)}`,
          ],
          ['ahead', 'the rest of a fast run'],
        ];
      return [['speed', 'speed run; dot: the end of a step, with its number']];
    case 'best':
      if (world === 'seconds') return [['fastest', 'the fastest run that the maze allows']];
      return [['best', mms ? 'a best possible run, cell by cell' : 'a shortest speed run; ring: the end of a step']];
    case 'candidates':
      return [
        [
          'candidates',
          'unseen wall that it considered in its last choice, with the steps of the run through it; pale: not worth it',
        ],
        ['chosen', 'the chosen one'],
      ];
    case 'mms':
      return [
        ['mms', 'colours and texts that the program drew'],
        ['drawn', 'wall that it drew, and that exists'],
        ['wrong', 'wall that it drew, but that does not exist'],
      ];
  }
}

const titles: Record<LayerName, string> = {
  walls: 'Walls',
  wrong: 'Wrong guesses',
  visits: 'Visits',
  distances: 'Distances',
  rays: 'Sensor rays',
  exploration: 'Exploration',
  speed: 'Speed run',
  best: 'Best possible run',
  candidates: 'Candidates',
  mms: 'Drawn by the program',
};

/** What a layer is called in seconds, where it is called otherwise. */
const titlesInSeconds: Partial<Record<LayerName, string>> = { speed: 'Path by speed', best: 'Fastest possible run' };

const always: Sign[] = [
  ['start', 'start'],
  ['goal', 'goal'],
  ['mouse', 'mouse'],
];
const signList = (signs: Sign[]) =>
  h('ul', { class: 'signs' }, ...signs.map(([name, words]) => h('li', {}, sample(name), h('span', {}, words))));

export function createLegend(state: State, actions: Actions): Panel {
  const lines = h('div', { class: 'layers' });
  const element = h('section', { class: 'legend' }, h('h3', {}, 'Layers'), lines);

  function choice<Mode extends string>(layer: LayerName, label: string, modes: [Mode, string][], value: Mode) {
    const set = () => actions.setLayers({ [layer]: select.value });
    const select = h(
      'select',
      { 'aria-label': label, onchange: set },
      ...modes.map(([name, words]) => h('option', { value: name }, words)),
    );
    select.value = value;
    return select;
  }
  const title = (layer: LayerName) =>
    (state.sides.every(({ track }) => track.drive) && titlesInSeconds[layer]) || titles[layer];
  function control(layer: LayerName): Child[] {
    const { layers, sides } = state;
    if (layer === 'walls') {
      const known = sides.every(({ track }) => track.play.world === 'mms')
        ? 'what the program drew'
        : 'what the mouse knows';
      const modes: [WallMode, string][] = [
        ['known', known],
        ['whole', 'the whole maze'],
      ];
      return [h('span', {}, titles.walls), choice('walls', 'Walls', modes, layers.walls)];
    }
    if (layer === 'distances') {
      const modes: [DistanceMode, string][] = [
        ['none', 'none'],
        ['true', 'true'],
      ];
      if (sides.some(({ track }) => track.play.known.length > 0)) modes.push(['believed', 'believed']);
      return [h('span', {}, titles.distances), choice('distances', 'Distances', modes, layers.distances)];
    }
    const box: HTMLInputElement = h('input', {
      type: 'checkbox',
      checked: layers[layer] as boolean,
      onchange: () => actions.setLayers({ [layer]: box.checked }),
    });
    return [h('label', {}, box, ' ', title(layer))];
  }
  function line(layer: LayerName): HTMLElement {
    const { layers, sides } = state;
    const on = layer === 'walls' || (layer === 'distances' ? layers.distances !== 'none' : layers[layer] === true);
    const most = Math.max(...sides.map(({ track }) => track.mostVisits));
    const { world } = sides[0].track.play;
    const fastest = Math.max(...sides.map(({ track }) => track.drive?.fastest ?? 0));
    const key = (layerNames.indexOf(layer) + 1) % 10;
    return h(
      'div',
      { class: on ? 'layer on' : 'layer' },
      h('div', { class: 'control' }, ...control(layer), h('kbd', {}, key)),
      on && signList(signsOf(layer, layers, world, most, fastest)),
    );
  }
  function draw() {
    const focused = document.activeElement;
    const place = [...lines.querySelectorAll('select, input')].indexOf(focused!);
    const shown = layerNames.filter((layer) => state.sides.some(({ track }) => has(track.play, layer)));
    lines.replaceChildren(signList(always), ...shown.map(line));
    if (place >= 0) lines.querySelectorAll<HTMLElement>('select, input')[place]?.focus();
  }
  let sides: unknown = null;
  let drawn = '';
  return {
    element,
    update() {
      const layers = JSON.stringify(state.layers);
      if (sides === state.sides && drawn === layers) return;
      sides = state.sides;
      drawn = layers;
      draw();
    },
  };
}
