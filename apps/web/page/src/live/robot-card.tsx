// The card of a real robot in Live: its source, its map, and what is found in it.
import { useEffect, useLayoutEffect, useState } from 'preact/hooks';
import type { About, MazeData } from '../core/types';
import { Button, Check, NumberInput, numberOf, Select } from '../ui/controls';
import { Field } from '../ui/field';
import { counted } from '../ui/format';
import type { Page } from '../page/page';
import { createRealRobot, type Wanted } from './real-robot';
import { RobotCurves } from './robot-curves';
import { createRobotMap, MapRoom } from './robot-map';
import { bauds, isServed, servedBegin, sourceNames, type SourceName } from './sources';

export type RobotPart = ReturnType<typeof createRobotPart>;

/** `draw` draws the view. */
export function createRobotPart(page: Page, draw: () => void) {
  const robot = createRealRobot(page, () => (map.update(), draw()));
  const map = createRobotMap(() => robot.state.past ?? robot.state.now);
  return { robot, map, about: page.about };
}

const usual = { source: 'serial' as SourceName, baud: 115200, address: 'ws://127.0.0.1:8000/', text: '', robot: '' };

interface Form extends Omit<Wanted, 'truth' | 'width' | 'height'> {
  isKnown: boolean;
  width: string;
  height: string;
}

interface FormProps {
  form: Form;
  about: About;
  set(changes: Partial<Form>): void;
}

const SourceFields = ({ form, set }: FormProps) => (
  <div class="field-row">
    <Field label="Source">
      <Select
        options={Object.entries(sourceNames())}
        value={form.source}
        choose={(source) => set({ source: source as SourceName })}
      />
    </Field>
    <Field label="Baud" hidden={form.source !== 'serial'}>
      <Select options={bauds.map(String)} value={form.baud} choose={(baud) => set({ baud: Number(baud) })} />
    </Field>
    <Field label="Address" hidden={form.source !== 'socket'}>
      <input type="text" value={form.address} onInput={({ currentTarget }) => set({ address: currentTarget.value })} />
    </Field>
    <Field label="Lines" hidden={form.source !== 'text'}>
      <textarea rows={4} value={form.text} onInput={({ currentTarget }) => set({ text: currentTarget.value })} />
    </Field>
  </div>
);

const MazeFields = ({ form, set, about }: FormProps) => (
  <div class="field-row">
    <Check label="In the maze chosen here" checked={form.isKnown} change={(isKnown) => set({ isKnown })} />
    <Field label="Width" hidden={form.isKnown}>
      <NumberInput min={1} value={form.width} change={(width) => set({ width })} />
    </Field>
    <Field label="Height" hidden={form.isKnown}>
      <NumberInput min={1} value={form.height} change={(height) => set({ height })} />
    </Field>
    <Field label="Plan routes for">
      <Select
        options={[['', 'no robot'], ...about.robots.map(({ name }) => [name])]}
        value={form.robot}
        choose={(robot) => set({ robot })}
      />
    </Field>
  </div>
);

/** Connects to the robot of `labmouse live --page`, in the maze and for the robot that it was given. */
async function connectServed(robot: RobotPart['robot'], form: Form) {
  const { maze, width, height, robot: name } = await servedBegin();
  const size = { width: width ?? numberOf(form.width), height: height ?? numberOf(form.height) };
  return robot.connect({ ...form, source: 'served', robot: form.robot || (name ?? ''), truth: maze ?? null, ...size });
}

/** What came, and what is found in it. */
function Seen({ part: { robot, map } }: { part: RobotPart }) {
  const { now, past, findings, curve, log, isOpen } = robot.state;
  useLayoutEffect(map.update, [now?.stream]);
  if (!now) return null;
  const shown = past ?? now;
  return (
    <>
      <MapRoom map={map} />
      {shown.advice && <p>{`${shown.advice}.`}</p>}
      <p>{`${counted(shown.lines, 'line')}, ${shown.noise} of them noise; ${counted(shown.restarts, 'restart')}`}</p>
      <Field label="Line" help={String(shown.lines)}>
        <input
          type="range"
          min={0}
          max={now.lines}
          value={shown.lines}
          onInput={({ currentTarget }) => void robot.look(Number(currentTarget.value))}
        />
      </Field>
      <RobotCurves points={curve.points()} />
      <ul aria-label="False and missed walls, and contradictions">
        {[...shown.wrong, ...shown.contradictions].map(({ words }) => (
          <li>{words}</li>
        ))}
      </ul>
      <details>
        <summary>{counted(findings.length, 'newest finding')}</summary>
        <ul>
          {findings.map(({ words }) => (
            <li>{words}</li>
          ))}
        </ul>
      </details>
      <div class="row">
        <Button label="Save the lines" disabled={log.size() === 0} act={robot.save} />
        {log.isFull() && <span>The first 64 MB are saved.</span>}
        {isOpen && <Button label="Disconnect" act={robot.disconnect} />}
      </div>
    </>
  );
}

export function RobotCard({ part, maze }: { part: RobotPart; maze: MazeData | null }) {
  const [form, setForm] = useState<Form>({ ...usual, ...(isServed() && { source: 'served' }), isKnown: false, width: '16', height: '16' });
  const set = (changes: Partial<Form>) => setForm((before) => ({ ...before, ...changes }));
  const { robot, about } = part;
  const connect = () => {
    if (form.source === 'served') return connectServed(robot, form).catch((error) => robot.fail(error));
    const { isKnown, width, height, ...rest } = form;
    const truth = isKnown ? maze : null;
    return robot.connect({ ...rest, truth, width: numberOf(width), height: numberOf(height) });
  };
  // Whoever opens the link of the program wants to see its robot.
  useEffect(() => void (isServed() && connect()), []);
  return (
    <section class="card real-robot" aria-label="Real robot">
      <h2>Real robot</h2>
      <SourceFields {...{ form, set, about }} />
      {form.source !== 'served' && <MazeFields {...{ form, set, about }} />}
      <Button label={form.source === 'text' ? 'Read' : 'Connect'} act={connect} />
      <p role="alert">{robot.state.error}</p>
      <Seen part={part} />
    </section>
  );
}
