// Several things chosen from a list, such as the mice and mazes of a race.
import type { About, MazeData } from '../core/types';
import { h } from '../ui/dom';

/** The mice that race where nobody chose others. */
export const usual = ['ariadne', 'flood-return', 'certify', 'flood', 'frontier'];
/** So many are named while the list is folded. */
const mostNamed = 6;

export interface Choice {
  name: string;
  about: string;
  on: boolean;
}

/** A list that is folded away. */
export function picks(title: string, choices: Choice[]) {
  const on = new Map<string, HTMLInputElement>();
  const list = h('div.list');
  const boxes = () => [...on.values()];
  const summary = h('summary');
  const chosen = () => boxes().flatMap((box) => (box.checked ? [box.value] : []));
  function count() {
    const names = chosen();
    const few = names.length > 0 && names.length <= mostNamed ? `: ${names.join(', ')}` : '';
    summary.replaceChildren(`${title}, ${names.length} of ${on.size}${few}`);
  }
  function setAll(checked: boolean) {
    boxes().forEach((box) => (box.checked = checked));
    count();
  }
  function offer(now: Choice[]) {
    const before = new Map(on);
    on.clear();
    for (const { name, on: checked } of now)
      on.set(name, before.get(name) ?? h('input', { type: 'checkbox', value: name, checked }));
    list.replaceChildren(...now.map(({ name, about }) => h('label', { title: about }, on.get(name)!, name)));
    count();
  }
  offer(choices);
  return {
    element: h(
      'details.picks',
      summary,
      h(
        'fieldset',
        { 'aria-label': title, onchange: count },
        h(
          'p.row',
          h('button', { type: 'button', onclick: () => setAll(true) }, 'All'),
          h('button', { type: 'button', onclick: () => setAll(false) }, 'None'),
        ),
        list,
      ),
    ),
    chosen,
    /** Chooses those and no others; of what is not offered it says so. */
    choose(names: string[]) {
      const missing = names.find((name) => !on.has(name));
      if (missing !== undefined) throw new Error(`This link cannot be followed: there is no '${missing}' here.`);
      for (const [name, box] of on) box.checked = names.includes(name);
      count();
    },
    /** Offers other things; what was chosen among those that stay is kept. */
    offer,
  };
}

/** Each under a name of its own, which is how results tell mazes apart. */
export function namedApart(mazes: MazeData[], taken: { name: string }[]): MazeData[] {
  const names = new Set(taken.map(({ name }) => name));
  return mazes.map((maze) => {
    const first = maze.name || 'drawing';
    let name = first;
    for (let count = 2; names.has(name); ++count) name = `${first}-${count}`;
    names.add(name);
    return { ...maze, name };
  });
}

/** Built-in mazes, and the user's own, which `mine` gives; `on` says whether those are chosen at first. */
export function mazePicks(title: string, { mazes }: About, mine: () => MazeData[], on: boolean) {
  const builtin = mazes.map(({ name, width, height }) => ({ name, about: `${width}×${height}`, on: true }));
  const list = picks(title, builtin);
  /** By the names under which they are offered. */
  let own = new Map<string, MazeData>();
  /** Offers those that there are by now. */
  function refresh() {
    const found = namedApart(mine(), builtin);
    own = new Map(found.map((maze) => [maze.name, maze]));
    const offered = found.map(({ name, width, height }) => ({ name, about: `${width}×${height}, yours`, on }));
    list.offer([...offered, ...builtin]);
  }
  refresh();
  return {
    ...list,
    refresh,
    own: () => own,
    /** Built-in ones by their names. */
    chosenMazes: () => list.chosen().map((name) => own.get(name) ?? name),
  };
}
