// The controls of time: buttons, the scrubber with the runs marked on it, the speed.
import { useRef } from 'preact/hooks';
import type { DriveRun } from '../core/types';
import { rateOf, speeds } from './clock';
import { short } from './figures';
import { Looks } from './looks';
import { Sign } from './sign';
import { timeOf, type Mark, type PanelProps, type Side } from './state';
import { momentText } from './words';
import { Button } from '../ui/controls';

/** Of a run in seconds. */
const runTones: Record<DriveRun['kind'], string> = {
  search: 'to-goal',
  home: 'onwards',
  speed: 'route',
  laps: 'route',
};

type Part = [tone: string, from: number, to: number];

/** How long it explored until the goal and from there on, and how long it ran; or each run of one that drives. */
function partsOf(side: Side): Part[] {
  const { track } = side;
  if (track.drive) return track.drive.runs.map(({ kind, begin, end }) => [runTones[kind], begin / 1e6, end / 1e6]);
  const stop = timeOf(side, 'end')!;
  if (track.play.traits.runs.length < 2) return [['to-goal', 0, stop]];
  const reset = timeOf(side, 'speed') ?? stop;
  const goal = Math.min(timeOf(side, 'goal') ?? reset, reset);
  return [
    ['to-goal', 0, goal],
    ['onwards', goal, reset],
    ['route', reset, stop],
  ];
}

function Strip({ side, end }: { side: Side; end: number }) {
  const share = (time: number) => `${end > 0 ? (100 * time) / end : 0}%`;
  const loss = timeOf(side, 'loss');
  return (
    <div class="strip">
      {partsOf(side).map(([tone, from, to]) => (
        <span class={tone} style={{ left: share(from), width: share(to - from) }} />
      ))}
      {loss !== null && <span class="loss" style={{ left: share(loss) }} />}
    </div>
  );
}

function Speed({ state: { clock, sides }, actions }: PanelProps) {
  const inSteps = sides.some(({ track }) => track.play.traits.clock === 'steps');
  return (
    <label class="speed">
      <span>Speed </span>
      <select
        aria-label="Speed"
        title="Speed (+ and −)"
        value={clock.speed}
        onChange={({ currentTarget }) => actions.setSpeed(Number(currentTarget.value))}
      >
        {speeds.map((speed, i) => (
          <option value={i}>{speed}×</option>
        ))}
        <option value={-1}>fit</option>
      </select>
      <span class="rate">
        {short(Math.round(rateOf(clock) * 100) / 100)} {inSteps ? 'steps/s' : 's/s'}
      </span>
    </label>
  );
}

const capital = (text: string) => text[0].toUpperCase() + text.slice(1);

/** Where in the contest a click leads: its runs, and the goal. */
function Marks({ state, actions }: PanelProps) {
  const side = state.sides[state.chosen];
  const { runs } = side.track.play.traits;
  const mark = (words: string, name: Mark) => (
    <Button label={words} class="mark" disabled={timeOf(side, name) === null} act={() => actions.jump(name)} />
  );
  return (
    <span class="marks">
      {runs.length > 1 && mark(capital(runs[0]), 'start')}
      {mark('Goal', 'goal')}
      {runs.length > 1 && mark(capital(runs[runs.length - 1]), 'speed')}
    </span>
  );
}

export function Transport({ state, actions }: PanelProps) {
  const { clock, sides } = state;
  // Who listens is not told of each moment of a replay that runs.
  const told = useRef('');
  if (!clock.playing) told.current = sides.map(momentText).join(' ');
  return (
    <>
      <div class="scrubber">
        <input
          type="range"
          min={0}
          max={clock.end}
          step="any"
          value={clock.time}
          aria-label="Moment of the replay"
          aria-valuetext={told.current}
          onInput={({ currentTarget }) => actions.seek(Number(currentTarget.value))}
        />
        <div class="strips" aria-hidden="true">
          {sides.map((side) => (
            <Strip side={side} end={clock.end} />
          ))}
        </div>
      </div>
      <div class="buttons" role="group" aria-label="Replay">
        <span class="moves">
          <Sign icon="start" label="To the start" keys="home" act={() => actions.jump('start')} />
          <Sign icon="back" label="One step back" keys="left arrow" act={() => actions.step(-1)} />
          <Sign
            icon={clock.playing ? 'pause' : 'play'}
            label={clock.playing ? 'Pause' : 'Play'}
            keys="space"
            act={actions.toggle}
          />
          <Sign icon="forward" label="One step forward" keys="right arrow" act={() => actions.step(1)} />
          <Sign icon="end" label="To the end" keys="end" act={() => actions.jump('end')} />
        </span>
        <Marks state={state} actions={actions} />
        <span class="pace">
          <Speed state={state} actions={actions} />
          <Sign
            icon="loop"
            label="Repeat from the start"
            keys="L"
            pressed={clock.loop}
            act={() => actions.setLoop(!clock.loop)}
          />
        </span>
      </div>
      <Looks folded={state.folded} actions={actions} />
    </>
  );
}
