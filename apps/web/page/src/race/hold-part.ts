// The part of the view in which a race is held, once the core has started.
import type { EarlyPage } from '../page/page';
import { h } from '../ui/dom';
import { holdPanel } from './hold-panel';
import { part } from './parts';

export type HoldPart = ReturnType<typeof holdPart>;

const fromCommandLine = () =>
  h(
    'details.note',
    h('summary', 'Or show results from the command line'),
    h(
      'p',
      'Write them with ',
      h('code', 'labmouse race --format json > results.json'),
      ' and drop the file anywhere on this page. ',
      h('code', 'labmouse report results.json -o report.html'),
      ' makes a separate page from them, with the replays.',
    ),
  );

/** `first`: there is no race yet, so it is not folded away. */
export function holdPart(page: EarlyPage, first: boolean) {
  const note = (text: string) => h('p.note', text);
  const room = h('div', note('Starting …'));
  const panel = page.ready.then((about) => holdPanel(page, about));
  panel.then(
    ({ element }) => room.replaceChildren(element),
    () => room.replaceChildren(note('This page cannot run races, because its core did not start.')),
  );
  const content = [room, fromCommandLine()];
  const element = first
    ? part('Run a race', 'Choose mice and mazes: the race runs in this page.', ...content)
    : h('details.part.controls', h('summary', 'Run another race'), ...content);
  return { element, panel };
}
