// Several things chosen from a list, such as the mice and mazes of a race.
import { useReducer } from 'preact/hooks';
import type { About, MazeData } from '../core/types';
import { Button } from '../ui/controls';

/** The mice that race where nobody chose others. */
export const usual = ['ariadne', 'flood-return', 'certify', 'flood', 'frontier'];
/** So many are named while the list is folded. */
const mostNamed = 6;

export interface Choice {
  name: string;
  about: string;
  on: boolean;
}

export type Picks = ReturnType<typeof createPicks>;

export function createPicks(title: string, first: Choice[]) {
  let choices = first;
  const set = (on: (choice: Choice) => boolean) => void (choices = choices.map((one) => ({ ...one, on: on(one) })));
  return {
    title,
    choices: () => choices,
    chosen: () => choices.flatMap(({ name, on }) => (on ? [name] : [])),
    set,
    /** Chooses those and no others; of what is not offered it says so. */
    choose(names: string[]) {
      const missing = names.find((wanted) => !choices.some(({ name }) => name === wanted));
      if (missing !== undefined) throw new Error(`This link cannot be followed: there is no '${missing}' here.`);
      set(({ name }) => names.includes(name));
    },
    /** Offers other things; what was chosen among those that stay is kept. */
    offer(now: Choice[]) {
      const before = new Map(choices.map(({ name, on }) => [name, on]));
      choices = now.map((one) => ({ ...one, on: before.get(one.name) ?? one.on }));
    },
  };
}

/** The list, folded away. */
export function PickList({ picks }: { picks: Pick<Picks, 'title' | 'choices' | 'chosen' | 'set'> }) {
  const [, draw] = useReducer((count: number) => count + 1, 0);
  const names = picks.chosen();
  const few = names.length > 0 && names.length <= mostNamed ? `: ${names.join(', ')}` : '';
  const set = (on: (choice: Choice) => boolean) => {
    picks.set(on);
    draw(0);
  };
  return (
    <details class="picks">
      <summary>
        {picks.title}, {names.length} of {picks.choices().length}
        {few}
      </summary>
      <fieldset aria-label={picks.title}>
        <p class="row">
          <Button label="All" act={() => set(() => true)} />
          <Button label="None" act={() => set(() => false)} />
        </p>
        <div class="list">
          {picks.choices().map(({ name, about, on }) => (
            <label title={about} key={name}>
              <input
                type="checkbox"
                value={name}
                checked={on}
                onChange={({ currentTarget: { checked } }) => set((one) => (one.name === name ? checked : one.on))}
              />
              {name}
            </label>
          ))}
        </div>
      </fieldset>
    </details>
  );
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
export function createMazePicks(title: string, { mazes }: About, mine: () => MazeData[], on: boolean) {
  const builtin = mazes.map(({ name, width, height }) => ({ name, about: `${width}×${height}`, on: true }));
  const list = createPicks(title, builtin);
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
