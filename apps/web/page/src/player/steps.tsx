// The list of all steps: a table of which only the lines in view exist.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { Meanings } from '../ui/meanings';
import { turnMeanings } from '../ui/terms';
import { headings, placeText } from './figures';
import type { PanelProps } from './state';
import type { Track } from './track';
import { Button } from '../ui/controls';

/** As high as fingers need it, or as eyes like it. */
const fingers = matchMedia('(max-width: 40rem), (pointer: coarse)');
const spare = 4;
/** Of the list before it is laid out, in pixels. */
const usualHeight = 320;

interface Column {
  name: string;
  text: (track: Track, frame: number) => string;
  /** Whether it says anything of such a contest; of all where that is missing. */
  has?: (track: Track) => boolean;
}

const columns: Column[] = [
  {
    name: 'run',
    text: ({ play, run, last }, i) => (i === last ? 'end' : play.traits.runs[run[i]]),
    has: ({ play }) => play.traits.runs.length > 1,
  },
  {
    name: 'seconds',
    text: ({ time, drive }, i) => time[i].toFixed(drive ? 3 : 2),
    has: ({ play }) => play.traits.clock === 'seconds',
  },
  { name: 'at', text: ({ x, y }, i) => placeText(x[i], y[i]) },
  { name: 'heading', text: ({ heading }, i) => headings[heading[i] & 7] },
  {
    name: 'left, ahead, right',
    text: ({ play: { left, ahead, right } }, i) => (i < left.length ? `${left[i]} ${ahead[i]} ${right[i]}` : ''),
    has: ({ play }) => play.left.length > 0,
  },
  { name: 'does', text: ({ play, last }, i) => (i < last ? play.action[i] : play.outcome) },
  {
    name: 'loses',
    text: ({ play }, i) => (play.loses[i] ? String(play.loses[i]) : ''),
    has: ({ play }) => play.loses.length > 0,
  },
  {
    name: 'blocked',
    text: ({ play, last }, i) => (i < last && play.blocked[i] ? 'by a wall' : ''),
    has: ({ drive }) => !drive,
  },
  {
    name: 'ends in',
    text: ({ play, last }, i) => (i < last && play.blocked[i] ? 'a crash' : ''),
    has: ({ play, drive }) => drive !== null && play.blocked.includes(true),
  },
  {
    name: 'takes, ms',
    text: ({ time, last }, i) => (i < last ? (1000 * (time[i + 1] - time[i])).toFixed(1) : ''),
    has: ({ drive }) => drive !== null,
  },
];

interface ListProps {
  track: Track;
  current: number;
  seek: (time: number) => void;
}

/** In the place of lines out of view. */
const Spacer = ({ height }: { height: number }) => (
  <tr aria-hidden="true" class="spacer" style={{ height: `${height}px` }} />
);

const Line = ({ track, current, seek, frame, shown }: ListProps & { frame: number; shown: Column[] }) => (
  <tr
    aria-rowindex={frame + 2}
    aria-current={frame === current ? 'step' : undefined}
    class={frame === track.lossFrame ? 'lost' : undefined}
    onClick={() => seek(track.time[frame])}
  >
    <th scope="row">
      <button type="button" tabIndex={-1} aria-label={frame === track.last ? 'the end' : `step ${frame + 1}`}>
        {frame === track.last ? '' : frame + 1}
      </button>
    </th>
    {shown.map(({ text }) => (
      <td>{text(track, frame)}</td>
    ))}
  </tr>
);

function List({ track, current, seek }: ListProps) {
  const scroller = useRef<HTMLDivElement>(null);
  const lineHeight = fingers.matches ? 44 : 24;
  const [top, setTop] = useState(0);
  const height = scroller.current?.clientHeight || usualHeight;
  const shown = columns.filter(({ has }) => has?.(track) ?? true);
  const first = Math.max(0, Math.floor(top / lineHeight) - spare);
  const end = Math.min(track.last + 1, first + Math.ceil(height / lineHeight) + 2 * spare);

  useLayoutEffect(() => {
    const list = scroller.current!;
    const room = height - 2 * lineHeight;
    const at = current * lineHeight;
    if (at >= list.scrollTop && at <= list.scrollTop + room) return;
    list.scrollTop = Math.max(0, current - Math.floor(room / lineHeight / 3)) * lineHeight;
    setTop(list.scrollTop);
  }, [current]);

  return (
    <div
      class="scroller"
      style={{ '--line-height': `${lineHeight}px` }}
      ref={scroller}
      tabIndex={0}
      role="region"
      aria-label="Steps"
      onScroll={() => setTop(scroller.current!.scrollTop)}
    >
      <table aria-label="Steps" aria-rowcount={track.last + 2}>
        <thead>
          <tr>
            {['step', ...shown.map(({ name }) => name)].map((name) => (
              <th scope="col">{name}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          <Spacer height={first * lineHeight} />
          {Array.from({ length: end - first }, (_, i) => (
            <Line key={first + i} frame={first + i} {...{ track, current, seek, shown }} />
          ))}
          <Spacer height={(track.last + 1 - end) * lineHeight} />
        </tbody>
      </table>
    </div>
  );
}

export function Steps({ state, actions }: PanelProps) {
  const { track, scene } = state.sides[state.chosen];
  return (
    <section class="steps">
      <h3>Steps</h3>
      <div class="chooser" role="group" aria-label="Whose steps" hidden={state.sides.length < 2}>
        {state.sides.map(({ name }, i) => (
          <Button label={name} title={name} aria-pressed={i === state.chosen} act={() => actions.choose(i)} />
        ))}
      </div>
      {track.drive && <Meanings of={turnMeanings.map(([name, meaning]) => [`turn ${name}`, meaning])} />}
      <List key={track} track={track} current={scene.past.frame} seek={actions.seek} />
    </section>
  );
}
