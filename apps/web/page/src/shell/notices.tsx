// What the page says: a quiet line of status, and what went wrong until it is dismissed.
import { CoreError } from '../core/client';
import type { CallName, Problem } from '../core/types';
import { errorText } from '../ui/format';
import { Button } from '../ui/controls';

const mostProblems = 12;
const mostAlerts = 4;

/** Something that the user can do about it. */
export interface Remedy {
  label: string;
  act: () => void;
}

/** A problem as the command line has it: "line 3, column 7: expected a wall". */
export function problemLine({ line, column, reason }: Problem): string {
  if (line > 0) return `line ${line}${column > 0 ? `, column ${column}` : ''}: ${reason}`;
  return column > 0 ? `byte ${column}: ${reason}` : reason;
}

/** What an error says: its message, and the places that it names. */
export function linesOf(error: unknown): { message: string; places: string[] } {
  const message = errorText(error);
  const problems = error instanceof CoreError ? error.problems : [];
  const places = problems
    .slice(0, mostProblems)
    .map(problemLine)
    .filter((place) => place !== message);
  if (problems.length > mostProblems) places.push(`and ${problems.length - mostProblems} more`);
  return { message, places };
}

export type Notices = ReturnType<typeof createNotices>;

const works: Partial<Record<CallName, string>> = {
  contest: 'The mouse runs …',
  race: 'Mice race …',
  open: 'Reading …',
  unpack: 'Reading …',
  beliefs: 'Asking what it believed …',
  make_maze: 'Making a maze …',
  losses: 'Finding where steps are lost …',
};

/** What went wrong, and what can be done about it. */
interface Alert {
  error: unknown;
  remedies: Remedy[];
}

export function createNotices() {
  const state = {
    /** What is said now. */
    message: '',
    remedies: [] as Remedy[],
    /** All that are not dismissed, the newest last. Only the newest are shown. */
    alerts: [] as Alert[],
    /** The call that takes long; null while none does. */
    work: null as CallName | null,
  };
  let listener = () => {};
  function set(changes: Partial<typeof state>) {
    Object.assign(state, changes);
    listener();
  }
  return {
    state,
    /** Calls after each change. */
    watch: (draw: () => void) => void (listener = draw),
    /** The name of a call that takes long, or null when it is over. */
    busy: (work: CallName | null) => set({ work }),
    tell: (message: string, ...remedies: Remedy[]) => set({ message, remedies }),
    complain: (error: unknown, ...remedies: Remedy[]) => set({ alerts: [...state.alerts, { error, remedies }] }),
    dismiss(closed: Alert[]) {
      set({ alerts: state.alerts.filter((alert) => !closed.includes(alert)) });
      document.querySelector<HTMLElement>('main')?.focus({ preventScroll: true });
    },
    clear: () => set({ alerts: [] }),
  };
}

export const Status = ({ notices: { state, tell } }: { notices: Notices }) => (
  <p class="status" role="status">
    {state.message && (
      <span>
        <span class="said" title={state.message}>
          {state.message}
        </span>
        {state.remedies.map(({ label, act }) => (
          <>
            {' '}
            <Button label={label} act={() => (tell(''), act())} />
          </>
        ))}
      </span>
    )}
  </p>
);

/** Offers to stop what takes long. */
export const Work = ({ notices: { state }, stop }: { notices: Notices; stop: () => void }) => (
  <p class="work" hidden={state.work === null}>
    <span>{state.work && (works[state.work] ?? 'Working …')}</span>
    <Button label="Stop this" act={stop} />
  </p>
);

/** Its message and the buttons in one line, its places below. */
function AlertBox({ alert: { error, remedies }, close }: { alert: Alert; close: () => void }) {
  const { message, places } = linesOf(error);
  return (
    <div class="alert">
      <p>{message}</p>
      <div class="row">
        {remedies.map(({ label, act }) => (
          <Button label={label} act={() => (close(), act())} />
        ))}
        <Button label="Dismiss" act={close} />
      </div>
      {places.length > 0 && (
        <ul>
          {places.map((place) => (
            <li>{place}</li>
          ))}
        </ul>
      )}
    </div>
  );
}

export function Alerts({ notices: { state, dismiss } }: { notices: Notices }) {
  const more = state.alerts.length - mostAlerts;
  return (
    <div class="alerts" role="alert">
      {state.alerts.slice(-mostAlerts).map((alert) => (
        <AlertBox key={alert} alert={alert} close={() => dismiss([alert])} />
      ))}
      {more > 0 && (
        <div class="more row">
          and {more} more
          <Button label="Dismiss all" act={() => dismiss(state.alerts)} />
        </div>
      )}
    </div>
  );
}
