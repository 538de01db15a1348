// The runs of a contest in seconds, as a list: what each was, how long it took, what it is worth.
import type { Drive, DriveRun } from '../core/types';
import { durationText, endText, gateToGate, kinds, madeOf } from './drive';
import type { PanelProps, Side } from './state';

const heads = ['run', 'begins', 'takes', 'gate to gate', 'known, possible', 'counts'];

/** Two times of one run stand side by side: what each is, and which of them counts. */
const timedBy = ({ gate_to_gate, counts }: Drive['rules']) =>
  counts === 'lap'
    ? '“takes” is the time from the beginning of a run to its end. “gate to gate” is the fastest lap of a run, which counts.'
    : '“takes” is the time from the beginning of a run to its end. “gate to gate” is the time from leaving the start cell to ' +
      `entering a goal. These rules count the time ${gate_to_gate ? 'from gate to gate' : 'from the beginning of a run to the middle of a goal'}.`;

function knownText({ known, possible }: DriveRun): string {
  if (known === null && possible === null) return '–';
  return `${durationText(known)}, ${known === possible ? 'proven' : durationText(possible)}`;
}

interface LineProps {
  side: Side;
  index: number;
  /** Whether the column of ends is there. */
  ends: boolean;
  /** To a time in microseconds. */
  jump: (time: number) => void;
}

/** A crash leads to its moment. */
function End({ run, jump }: { run: DriveRun; jump: LineProps['jump'] }) {
  const { crash } = run;
  if (!crash) return <td>{endText(run)}</td>;
  return (
    <td class="crash">
      <button type="button" onClick={() => jump(crash.time)}>
        {durationText(crash.time)}, {endText(run)}
      </button>
    </td>
  );
}

function Line({ side, index, ends, jump }: LineProps) {
  const { runs, drive } = side.track.drive!;
  const run = runs[index];
  const value = run.score ? durationText(run.score.value) : '–';
  return (
    <tr class={run.score?.best ? 'best' : ''} aria-current={side.scene.moment?.run === index ? 'true' : undefined}>
      <th scope="row">
        <button type="button" onClick={() => jump(run.begin)}>
          {index + 1} {kinds[run.kind]}
        </button>
      </th>
      <td>{durationText(run.begin)}</td>
      <td>{durationText(run.end - run.begin)}</td>
      <td>{durationText(gateToGate(run))}</td>
      <td>{knownText(run)}</td>
      <td title={madeOf(run, drive.rules)}>{run.score?.best ? <strong>{value} best</strong> : value}</td>
      {ends && <End run={run} jump={jump} />}
    </tr>
  );
}

export function Runs({ state: { sides }, actions }: PanelProps) {
  const driven = sides.filter(({ track }) => track.drive);
  if (driven.length === 0) return null;
  return (
    <section class="drive-runs">
      <h3>Runs</h3>
      {driven.map((side) => {
        const { drive, runs } = side.track.drive!;
        const jump = (time: number) => {
          actions.choose(sides.indexOf(side));
          actions.seek(time / 1e6);
        };
        const ends = runs.some(({ ended }) => ended !== null);
        return (
          <>
            <p class="note">{timedBy(drive.rules)}</p>
            <div class="wide" tabIndex={0} role="region" aria-label={`Runs of ${side.name}`}>
              <table>
                <caption>
                  {side.name}: robot {drive.robot.name}, rules {drive.rules.name}
                </caption>
                <thead>
                  <tr>
                    {[...heads, ...(ends ? ['ends'] : [])].map((text) => (
                      <th scope="col">{text}</th>
                    ))}
                  </tr>
                </thead>
                <tbody>
                  {runs.map((_, index) => (
                    <Line side={side} index={index} ends={ends} jump={jump} />
                  ))}
                </tbody>
              </table>
            </div>
          </>
        );
      })}
    </section>
  );
}
