// What stands below the editor: the maze, what starts and stops, and what is said of it.
import type { Page } from '../page/page';
import type { Progress } from '../results/holding';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import type { Work } from './keeping';
import { createMazeSelect } from './maze-select';
import { createRaceForm } from './race-form';

export type Controls = ReturnType<typeof createControls>;

interface Acts {
  run(): void;
  race(): void;
  stop(): void;
  /** What would run; null while nothing may. */
  work(): Work | null;
}

export function createControls(page: Page, { run, race, stop, work }: Acts) {
  const mazes = createMazeSelect(page);
  const form = createRaceForm(page);
  const starts = [button('Run', run, { class: 'main' }), button('Race', race)];
  const end = button('Stop', stop, { hidden: true });
  const verdict = h('p.verdict', { role: 'status', hidden: true });
  const bar = h('progress', { hidden: true, 'aria-label': 'Progress of the race' });
  const hint = h(
    'p.note.hint',
    'Change the program, then run it in one maze and step through what it did, or race it against other mice.',
  );
  const maze = h('label', h('span.unseen', 'Maze'), mazes.element);
  const enable = (is: boolean) => starts.forEach((one) => (one.disabled = !is));
  function say(text: string, state: 'good' | 'bad' | 'fair') {
    verdict.hidden = false;
    verdict.dataset.state = state;
    verdict.replaceChildren(text);
  }
  return {
    element: h('div.desk-controls', h('div.row.bar', maze, ...starts, end, bar), hint, verdict, form.element),
    mazes,
    form,
    hint,
    verdict,
    isIdle: () => end.hidden,
    /** As if somebody had pressed it. */
    run: () => starts[0].click(),
    refresh() {
      mazes.refresh();
      form.refresh();
      enable(work() !== null);
    },
    busy(is: boolean) {
      end.hidden = !is;
      enable(!is && work() !== null);
      bar.hidden ||= !is;
    },
    say,
    report({ done, all, doing }: Progress) {
      bar.hidden = false;
      bar.max = all;
      bar.value = done;
      say(`${doing} …`, 'fair');
    },
  };
}
