// The part of the view in which a race is held, once the core has started.
import type { EarlyPage } from '../page/page';
import { createHoldPanel, HoldForm, type HoldPanel } from './hold-panel';
import { Part } from './parts';

export type Hold = ReturnType<typeof createHold>;

/** `draw` is called after each change. */
export function createHold(page: EarlyPage, draw: () => void) {
  const state = { panel: null as HoldPanel | null, isBroken: false };
  const panel = page.ready.then((about) => createHoldPanel(page, about, draw));
  panel
    .then(
      (panel) => Object.assign(state, { panel }),
      () => Object.assign(state, { isBroken: true }),
    )
    .then(draw);
  return { state, panel };
}

const FromCommandLine = () => (
  <details class="note">
    <summary>Or show results from the command line</summary>
    <p>
      Write them with <code>labmouse race --format json &gt; results.json</code> and drop the file anywhere on this
      page. <code>labmouse report results.json -o report.html</code> makes a separate page from them, with the replays.
    </p>
  </details>
);

const Form = ({ panel, isBroken }: Hold['state']) => (
  <div>
    {panel ? (
      <HoldForm panel={panel} />
    ) : (
      <p class="note">{isBroken ? 'This page cannot run races, because its core did not start.' : 'Starting …'}</p>
    )}
  </div>
);

/** `first`: there is no race yet, so it is not folded away. */
export const HoldPart = ({ hold: { state }, first }: { hold: Hold; first: boolean }) =>
  first ? (
    <Part title="Run a race" about="Choose mice and mazes: the race runs in this page.">
      <Form {...state} />
      <FromCommandLine />
    </Part>
  ) : (
    <details class="part controls">
      <summary>Run another race</summary>
      <Form {...state} />
      <FromCommandLine />
    </details>
  );
