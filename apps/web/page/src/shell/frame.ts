// What stands around the views.
import { h, svg, type Attributes } from '../ui/dom';
import { createMenu } from './menu';
import type { Shelf } from '../page/shelf';
import { themeSwitch } from './theme';
import { titleOf, viewNames, type ViewName } from '../link/routes';
import type { Notices } from './notices';
import type { Intake } from './drop';

export type Frame = ReturnType<typeof createFrame>;

const sign = (size: number, path: Attributes) =>
  svg(
    'svg',
    { viewBox: '0 0 24 24', width: size, height: size, 'aria-hidden': 'true', focusable: 'false' },
    svg('path', path),
  );
/** The mouse of the pictures. */
const mouse = { d: 'M12 2l8 19-8-5-8 5z', fill: 'currentColor' };
const folder = { d: 'M3 5h6l2 2h10v12H3zM5 9v8h14V9z', fill: 'currentColor' };
const chain = {
  ...{ d: 'M10 14l4-4M9 7l2-2a4.2 4.2 0 0 1 6 6l-2 2M15 17l-2 2a4.2 4.2 0 0 1-6-6l2-2', fill: 'none' },
  ...{ stroke: 'currentColor', 'stroke-width': 2, 'stroke-linecap': 'round' },
};

export function createFrame(notices: Notices, intake: Intake, shelf: Shelf, copyLink: () => void) {
  const tabs = new Map(viewNames.map((name) => [name, h('a', { href: `#${name}` }, titleOf(name))]));
  const main = h('main', { id: 'main', tabindex: -1 });
  const open = h(
    'button.open',
    { type: 'button', onclick: intake.choose, title: 'A maze, a record or the results of a race' },
    sign(18, folder),
    h('span', 'Open file'),
  );
  const link = h(
    'button.open',
    { type: 'button', onclick: copyLink, title: 'A link to what is seen now' },
    sign(18, chain),
    h('span', 'Copy link'),
  );
  const skip = h('button.skip', { type: 'button', onclick: () => main.focus() }, 'Skip to the content');
  const header = h(
    'header.top',
    skip,
    h('h1', h('a.brand', { href: '#home', title: 'To the home page' }, sign(22, mouse), h('span', 'labmouse'))),
    h('nav', { 'aria-label': 'Views' }, ...tabs.values()),
    notices.status,
    notices.work,
    createMenu([open, link, themeSwitch()], shelf, notices),
  );
  document.getElementById('page')!.replaceChildren(header, notices.alerts, main, intake.overlay);
  return {
    main,
    /** Marks the view that is shown, in the navigation and in the title. */
    mark(view: ViewName) {
      for (const [name, tab] of tabs) {
        if (name === view) {
          tab.setAttribute('aria-current', 'page');
          tab.scrollIntoView({ block: 'nearest', inline: 'nearest', behavior: 'instant' });
        } else tab.removeAttribute('aria-current');
      }
      document.title = view === 'home' ? 'labmouse' : `${titleOf(view)} · labmouse`;
    },
  };
}
