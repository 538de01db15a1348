// The page: four views around one core.
import CoreWorker from './core/worker?worker&inline';
import { CoreError, startCore } from './core/client';
import type { MazeData, Play } from './core/types';
import { h } from './ui/dom';
import { createDraw } from './views/draw';
import { createLive } from './views/live';
import { createRace } from './views/race';
import { createReplay } from './views/replay';
import type { Page, View } from './views/view';
import './styles/page.css';

async function start() {
  const core = startCore(new CoreWorker());
  const about = await core.call('about', {});
  const status = h('p', { role: 'status', class: 'status' });
  const views: Record<string, View> = {};

  function show(name: string, thing?: unknown) {
    for (const [other, view] of Object.entries(views)) {
      if (other !== name && !view.element.hidden) view.hidden?.();
      view.element.hidden = other !== name;
      tabs[other].setAttribute('aria-current', other === name ? 'page' : 'false');
    }
    if (thing !== undefined) views[name].accept?.(thing);
    views[name].shown();
  }

  const page: Page = {
    core,
    about,
    race: () => null,
    replay: (plays: { play: Play; record: string }[]) => show('replay', plays),
    live: (maze: MazeData) => show('live', maze),
    draw: (maze: MazeData) => show('draw', maze),
    drawn: () => null,
    tell: (message) => status.replaceChildren(message),
    complain(error) {
      const lines = error instanceof CoreError ? error.problems.map((p) => `${p.line}:${p.column}: ${p.reason}`) : [];
      status.replaceChildren([error instanceof Error ? error.message : String(error), ...lines].join('\n'));
    },
    save(fileName, content, type = 'text/plain') {
      const url = URL.createObjectURL(new Blob([content], { type }));
      h('a', { href: url, download: fileName }).click();
      setTimeout(() => URL.revokeObjectURL(url), 10_000);
    },
  };
  views.race = createRace(page);
  views.replay = createReplay(page);
  views.live = createLive(page);
  views.draw = createDraw(page);
  const tabs: Record<string, HTMLElement> = {};
  for (const name of Object.keys(views)) tabs[name] = h('a', { href: `#${name}` }, name[0].toUpperCase() + name.slice(1));
  addEventListener('hashchange', () => views[location.hash.slice(1)] && show(location.hash.slice(1)));
  document
    .getElementById('page')!
    .append(
      h('header', {}, h('h1', {}, 'labmouse'), h('nav', { 'aria-label': 'Views' }, ...Object.values(tabs))),
      status,
      h('main', {}, ...Object.values(views).map((view) => view.element)),
    );
  show(location.hash.slice(1) in views ? location.hash.slice(1) : 'race');
}

void start();
