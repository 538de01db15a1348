// What the page says: a quiet line of status, and what went wrong until it is dismissed.
import { CoreError } from '../core/client';
import type { CallName, Problem } from '../core/types';
import { h } from '../ui/dom';
import { errorText } from '../ui/format';

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

/** What went wrong, in a box: its message and the buttons in one line, its places below. */
function alertOf(error: unknown, remedies: Remedy[], close: (alert: HTMLElement) => void): HTMLElement {
  const { message, places } = linesOf(error);
  const button = ({ label, act }: Remedy) => h('button', { type: 'button', onclick: act }, label);
  const alert: HTMLElement = h(
    'div.alert',
    h('p', message),
    h(
      'div.row',
      ...remedies.map(({ label, act }) => button({ label, act: () => (close(alert), act()) })),
      button({ label: 'Dismiss', act: () => close(alert) }),
    ),
    places.length > 0 && h('ul', ...places.map((place) => h('li', place))),
  );
  return alert;
}

const works: Partial<Record<CallName, string>> = {
  contest: 'The mouse runs …',
  race: 'Mice race …',
  open: 'Reading …',
  unpack: 'Reading …',
  beliefs: 'Asking what it believed …',
  make_maze: 'Making a maze …',
  losses: 'Finding where steps are lost …',
};

export function createNotices() {
  const status = h('p.status', { role: 'status' });
  const alerts = h('div.alerts', { role: 'alert' });
  /** All that are not dismissed, the newest last. Only the newest are shown. */
  let open: HTMLElement[] = [];

  function show() {
    const more = open.length - mostAlerts;
    alerts.replaceChildren(...open.slice(-mostAlerts));
    if (more <= 0) return;
    const clear = h('button', { type: 'button', onclick: () => dismiss(...open) }, 'Dismiss all');
    alerts.append(h('div.more.row', `and ${more} more`, clear));
  }
  function dismiss(...closed: HTMLElement[]) {
    open = open.filter((alert) => !closed.includes(alert));
    show();
    document.querySelector<HTMLElement>('main')?.focus({ preventScroll: true });
  }
  const what = h('span');
  const stop = h('button', { type: 'button' }, 'Stop this');
  const work = h('p.work', { hidden: true }, what, stop);
  return {
    /** Offers to stop what takes long. */
    work,
    /** The name of a call that takes long, or null when it is over. */
    busy(name: CallName | null) {
      work.hidden = name === null;
      if (name) what.textContent = works[name] ?? 'Working …';
    },
    onStop: (act: () => void) => stop.addEventListener('click', act),
    status,
    alerts,
    tell: (message: string, ...remedies: Remedy[]) =>
      status.replaceChildren(
        h(
          'span',
          h('span.said', { title: message }, message),
          ...remedies.flatMap(({ label, act }) => [
            ' ',
            h('button', { type: 'button', onclick: () => (status.replaceChildren(), act()) }, label),
          ]),
        ),
      ),
    complain(error: unknown, ...remedies: Remedy[]) {
      open.push(alertOf(error, remedies, dismiss));
      show();
    },
    clear() {
      open = [];
      show();
    },
  };
}
