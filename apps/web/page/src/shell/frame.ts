// What stands around the views.
import { h } from '../ui/dom';
import { themeSwitch } from './theme';
import { titleOf, viewNames, type ViewName } from './routes';
import type { Notices } from './notices';
import type { Intake } from './drop';

export interface Frame {
  main: HTMLElement;
  /** Marks the view that is shown, in the navigation and in the title. */
  mark(view: ViewName): void;
}

export function createFrame(notices: Notices, intake: Intake): Frame {
  const tabs = new Map(viewNames.map((name) => [name, h('a', { href: `#${name}` }, titleOf(name))]));
  const main = h('main', { id: 'main', tabindex: -1 });
  const skip = h('button', { type: 'button', class: 'skip', onclick: () => main.focus() }, 'Skip to the content');
  const header = h(
    'header',
    { class: 'top' },
    skip,
    h('h1', {}, 'labmouse'),
    h('nav', { 'aria-label': 'Views' }, ...tabs.values()),
    h(
      'div',
      { class: 'tools' },
      h(
        'button',
        { type: 'button', onclick: intake.choose, title: 'A maze, a record or the results of a race' },
        'Open file',
      ),
      themeSwitch(),
    ),
  );
  document.getElementById('page')!.replaceChildren(header, notices.status, notices.alerts, main, intake.overlay);
  return {
    main,
    mark(view) {
      for (const [name, tab] of tabs) {
        if (name === view) tab.setAttribute('aria-current', 'page');
        else tab.removeAttribute('aria-current');
      }
      document.title = `${titleOf(view)} · labmouse`;
    },
  };
}
