// The layers as toggles, each with what its signs mean: the legend of the pictures.
import type { ComponentChildren } from 'preact';
import type { Play } from '../core/types';
import { has, isUsual, layerNames, usualLayers, type LayerName, type Layers } from './layers';
import { Sample, type SampleName } from './samples';
import type { PanelProps, Side } from './state';
import { Button } from '../ui/controls';

const tints = '; if the cells are too small for numbers, a tone, stronger when nearer';

type Sign = [SampleName, string];

/** What decides what the signs of a layer say. */
interface Shown {
  layers: Layers;
  play: Play;
  /** The most visits to a cell, and the highest speed. */
  most: number;
  fastest: number;
}

function wallSigns({ layers: { walls }, play: { traits, mistaken } }: Shown): Sign[] {
  const wrong: Sign[] = [
    ['wrong', 'there is no wall, but the mouse has read one'],
    ['overlooked', 'there is a wall, but the mouse has read none'],
  ];
  if (traits.draws && walls !== 'known') return [['walls', 'wall of the maze']];
  if (traits.draws)
    return [
      ['drawn', 'wall that the program drew, and that exists'],
      ['unseen', 'wall that it has not drawn yet'],
    ];
  const [known, other]: Sign[] =
    walls === 'known'
      ? [
          ['walls', 'wall that the mouse knows so far'],
          ['unknown', 'not known yet: open or closed'],
        ]
      : [
          ['walls', 'wall'],
          ['unseen', 'wall that the mouse does not know yet'],
        ];
  return [known, other, ...(mistaken ? wrong : [])];
}

function distanceSigns({ layers, play: { drive } }: Shown): Sign[] {
  const unit = drive ? 'cells' : 'steps';
  const believed = `${unit} to the goal as the mouse believed, assuming that all unknown walls are open${tints}`;
  const whole = `${unit} to the goal, in the whole maze${tints}`;
  return [['distances', layers.distances === 'believed' ? believed : whole]];
}

function runSigns({ play: { drive }, fastest }: Shown): Sign[] {
  if (!drive) return [['speed', 'speed run; dot: the end of a step, with its number']];
  const steps = `0 to ${fastest.toFixed(2)} m/s, in steps of ${(fastest / 6).toFixed(2)}`;
  return [
    ['speeds', `its path in this run so far: ${steps}`],
    ['ahead', 'the rest of a speed run'],
  ];
}

function bestSigns({ play: { drive, traits } }: Shown): Sign[] {
  if (drive) return [['fastest', 'the fastest run that the maze allows']];
  if (traits.runs.length < 2) return [['best', 'a best possible run, cell by cell']];
  return [['best', 'a shortest speed run; ring: the end of a step']];
}

const beams: Sign[] = [
  ['rays', 'infrared beams, as far as what they read says'],
  ['believed', 'the mouse that it thinks it is; where it differs it may crash'],
  ['wrong', 'a wall that it read about the cell, and a cross where it touched one'],
  ['search', 'no wall that it read there; paler where it was less sure'],
];

/** What each layer's signs say. */
const signsOf: Record<LayerName, (shown: Shown) => Sign[]> = {
  walls: wallSigns,
  wrong: () => [['wrong', 'closed, but not known yet: assuming that unknown walls are open is wrong here']],
  visits: ({ most }) => [['visits', most > 1 ? `1 to ${most} visits to a cell so far` : '1 visit to a cell']],
  distances: distanceSigns,
  rays: ({ play: { drive } }) =>
    drive ? beams : [['rays', 'open cells to the left, ahead and to the right, read before the next step']],
  search({ play: { traits } }) {
    const isOne = traits.runs.length < 2;
    return [
      ['search', isOne ? 'way to the goal' : 'path of the search run to the goal'],
      ['onwards', isOne ? 'way from there on' : 'its path from there on'],
    ];
  },
  speed: runSigns,
  best: bestSigns,
  candidates: () => [
    [
      'candidates',
      'unseen wall that it considered in its last choice, with the steps of the run through it; pale: not worth it',
    ],
    ['chosen', 'the chosen one'],
  ],
  mms: () => [
    ['mms', 'colours and texts that the program drew'],
    ['drawn', 'wall that it drew, and that exists'],
    ['wrong', 'wall that it drew, but that does not exist'],
  ],
};

const titles: Record<LayerName, string> = {
  walls: 'Walls',
  wrong: 'Wrong guesses',
  visits: 'Visits',
  distances: 'Distances',
  rays: 'Sensor rays',
  search: 'Search',
  speed: 'Speed run',
  best: 'Best possible run',
  candidates: 'Candidates',
  mms: 'Drawn by the program',
};

/** What a layer is called of a robot that drives, where it is called otherwise. */
const titlesOfDrives: Partial<Record<LayerName, string>> = {
  speed: 'Path by speed',
  best: 'Fastest possible run',
  rays: 'Beams and beliefs',
};

const titleOf = (layer: LayerName, sides: Side[]) =>
  (sides.every(({ track }) => track.drive) && titlesOfDrives[layer]) || titles[layer];

const Signs = ({ of }: { of: Sign[] }) => (
  <ul class="signs">
    {of.map(([name, words]) => (
      <li>
        <Sample name={name} />
        <span>{words}</span>
      </li>
    ))}
  </ul>
);

/** The modes of a layer that has more than on and off, each with its words. */
function modesOf(layer: LayerName, sides: Side[]): [string, string][] | null {
  if (layer === 'walls') {
    const draws = sides.every(({ track }) => track.play.traits.draws);
    return [
      ['known', draws ? 'what the program drew' : 'what the mouse knows'],
      ['whole', 'the whole maze'],
    ];
  }
  if (layer !== 'distances') return null;
  const believes = sides.some(({ track }) => track.play.known.length > 0);
  return [['none', 'none'], ['true', 'true'], ...(believes ? [['believed', 'believed'] as [string, string]] : [])];
}

function Control({ layer, state: { layers, sides }, actions }: PanelProps & { layer: LayerName }): ComponentChildren {
  const modes = modesOf(layer, sides);
  if (!modes)
    return (
      <label>
        <input
          type="checkbox"
          checked={layers[layer] === true}
          onChange={({ currentTarget }) => actions.setLayers({ [layer]: currentTarget.checked })}
        />{' '}
        {titleOf(layer, sides)}
      </label>
    );
  return (
    <>
      <span>{titles[layer]}</span>
      <select
        aria-label={titles[layer]}
        value={String(layers[layer])}
        onChange={({ currentTarget }) => actions.setLayers({ [layer]: currentTarget.value })}
      >
        {modes.map(([name, words]) => (
          <option value={name}>{words}</option>
        ))}
      </select>
    </>
  );
}

export function Legend(props: PanelProps) {
  const { layers, sides } = props.state;
  const most = Math.max(...sides.map(({ track }) => track.mostVisits));
  const fastest = Math.max(...sides.map(({ track }) => track.drive?.fastest ?? 0));
  const isOn = (layer: LayerName) => layers[layer] !== false && layers[layer] !== 'none';
  return (
    <section class="legend">
      <h3>Layers</h3>
      <div class="layers">
        <Signs
          of={[
            ['start', 'start'],
            ['goal', 'goal'],
            ['mouse', 'mouse'],
          ]}
        />
        {layerNames
          .filter((layer) => sides.some(({ track }) => has(track.play, layer)))
          .map((layer) => (
            <div key={layer} class={isOn(layer) ? 'layer on' : 'layer'}>
              <div class="control">
                <Control layer={layer} {...props} />
                <kbd>{(layerNames.indexOf(layer) + 1) % 10}</kbd>
              </div>
              {isOn(layer) && <Signs of={signsOf[layer]({ layers, play: sides[0].track.play, most, fastest })} />}
            </div>
          ))}
      </div>
      <Button
        label="Layers as at first"
        class="quiet"
        hidden={isUsual(layers)}
        act={() => props.actions.setLayers(usualLayers)}
      />
    </section>
  );
}
