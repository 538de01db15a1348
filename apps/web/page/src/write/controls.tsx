// What stands below the editor: the maze, what starts and stops, and what is said of it.
import type { ComponentChildren } from 'preact';
import type { Page } from '../page/page';
import type { Progress } from '../results/holding';
import type { Work } from './keeping';
import { createMazeSelect, MazeField } from './maze-select';
import { createRaceForm, RaceFields } from './race-form';
import { Button } from '../ui/controls';

export type Controls = ReturnType<typeof createControls>;

type Kind = 'good' | 'bad' | 'fair';

interface Acts {
  run(): void;
  race(): void;
  stop(): void;
  /** What would run; null while nothing may. */
  work(): Work | null;
}

/** `draw` is called after each change. */
export function createControls(page: Page, acts: Acts, draw: () => void) {
  const form = createRaceForm(page);
  const state = {
    isBusy: false,
    /** Of a race that is under way. */
    progress: null as Progress | null,
    /** Null where nothing is said. */
    verdict: null as { text: string; kind: Kind } | null,
    /** Nothing has been run yet. */
    isNew: true,
  };
  function set(changes: Partial<typeof state>) {
    Object.assign(state, changes);
    draw();
  }
  const mayStart = () => !state.isBusy && acts.work() !== null;
  return {
    acts,
    mazes: createMazeSelect(page),
    form,
    state,
    set,
    draw,
    mayStart,
    /** As if somebody had pressed it. */
    run: () => mayStart() && acts.run(),
    refresh() {
      form.mazes.refresh();
      draw();
    },
    busy: (isBusy: boolean) => set({ isBusy, ...(!isBusy && { progress: null }) }),
    say: (text: string, kind: Kind) => set({ verdict: { text, kind } }),
    report: (progress: Progress) => set({ progress, verdict: { text: `${progress.doing} …`, kind: 'fair' } }),
  };
}

/** What the program printed stands below what is said of it. */
export function ControlsRoom({ controls, children }: { controls: Controls; children: ComponentChildren }) {
  const { acts, mazes, form, state, draw, mayStart } = controls;
  const { isBusy, progress, verdict, isNew } = state;
  return (
    <div class="desk-controls">
      <div class="row bar">
        <MazeField mazes={mazes} draw={draw} />
        <Button label="Run" class="main" disabled={!mayStart()} act={acts.run} />
        <Button label="Race" disabled={!mayStart()} act={acts.race} />
        <Button label="Stop" hidden={!isBusy} act={acts.stop} />
        {progress && <progress aria-label="Progress of the race" max={progress.all} value={progress.done} />}
      </div>
      <p class="note hint" hidden={!isNew}>
        Change the program, then run it in one maze and step through what it did, or race it against other mice.
      </p>
      <p class="verdict" role="status" hidden={!verdict} data-state={verdict?.kind}>
        {verdict?.text}
      </p>
      {children}
      <RaceFields form={form} />
    </div>
  );
}
