// Which contest is played: one of our mice or of the user's own, in any maze, alone or beside another.
import type { Core } from '../core/client';
import type { About, Fields, MazeData, Play, WorldInPage } from '../core/types';
import { namedApart } from '../choice/picks';
import { mazesOf } from '../results/holding';
import type { Page } from '../page/page';
import { holdContest } from '../write/contest';
import type { Work } from '../write/keeping';
import { kept } from '../write/stored';
import { languages } from '../write/languages';
import { createCage } from '../write/sandbox/cage';
import type { Shown } from '../player/side';
import { Button } from '../ui/controls';

export interface Picked {
  world: string;
  mouse: string;
  /** The mouse beside it; empty for none. */
  beside: string;
  maze: string;
}

const seed = 1;
const usualMouse = 'ariadne';

/** A name that no mouse of ours has. */
const ownName = ({ language }: Work) => `own:${language.id}`;

/** What was written in Write, one of each language. */
export const ownMice = (): Work[] => languages.flatMap(({ id }) => kept(id) ?? []);

/** What a contest is asked besides, where nobody says otherwise. */
export const usualSettings = ({ settings }: WorldInPage) =>
  Object.fromEntries(
    settings.map(({ name, type, default: usual }) => [
      name,
      type === 'whole' ? Number(usual) : type === 'flag' ? usual === 'true' : usual,
    ]),
  );

/** A world in which single contests are run, by its name; the first one where it is none. */
export const worldNamed = ({ worlds }: About, name: string): WorldInPage =>
  worlds.find((one) => one.name === name && one.plays) ?? worlds[0];

/** A contest of a mouse of ours. */
const ours = (core: Core, world: WorldInPage, mouse: string, maze: MazeData, settings = {}): Promise<Shown> =>
  core.call('contest', { world: world.name, mouse, maze, seed, ...usualSettings(world), ...settings });

/** In seconds: so long before belief and truth part a contest to watch begins. */
const before = 2;

/** When belief and truth part for the first time, and a little before that. */
function partingTime({ clock, mistaken }: Play) {
  const first = mistaken?.[0];
  return first ? Math.max(0, clock[first.from] - before) : 0;
}

interface FormProps {
  picked: Picked;
  about: About;
  own: Work[];
  mazes: MazeData[];
  choose(change: Partial<Picked>): void;
  open(): void;
  part(): void;
  /** Those of the contest that are not the usual ones, in words. */
  conditions: string;
}

/** The mice that run in that world. */
const Mice = ({ about, own, world }: Pick<FormProps, 'about' | 'own'> & { world: WorldInPage }) => (
  <>
    {world.in_steps && own.length > 0 && (
      <optgroup label="Yours">
        {own.map((work) => (
          <option value={ownName(work)}>
            {work.name || 'unnamed'}, in {work.language.name}
          </option>
        ))}
      </optgroup>
    )}
    <optgroup label="Ours">
      {about.mice
        .filter(({ name }) => world.mice.includes(name))
        .map(({ name }) => (
          <option value={name}>{name}</option>
        ))}
    </optgroup>
  </>
);

const Mazes = ({ about, mazes }: Pick<FormProps, 'about' | 'mazes'>) => (
  <>
    {mazes.map(({ name }) => (
      <option value={name}>{name}, yours</option>
    ))}
    {about.mazes.map(({ name, width, height }) => (
      <option value={name}>
        {name}, {width} × {height}
      </option>
    ))}
  </>
);

/** Where contests come from that are not chosen here. */
const Others = ({ own, open, part, conditions }: Pick<FormProps, 'own' | 'open' | 'part' | 'conditions'>) => (
  <>
    <p class="note">
      Real mice err: <Button label="Watch belief and truth part" act={part} /> and come together again.
      {conditions && ` Here: ${conditions}.`}
    </p>
    <p class="note">
      {own.length === 0 && (
        <>
          <a href="#write">Write a mouse</a> of your own, and it stands here, too.{' '}
        </>
      )}
      A record holds a contest step by step: drop one anywhere on this page, or{' '}
      <Button label="Open a record" act={open} />. They are written by{' '}
      <code>labmouse run MOUSE MAZE --record FILE</code>, by races with <code>--out DIR</code>, by programs for mms, and
      by real robots; with <code>--explain</code> they also say why ariadne went where it did.
    </p>
  </>
);

function Form({ picked, about, own, mazes, choose, ...others }: FormProps) {
  const world = worldNamed(about, picked.world);
  const select = (label: string, field: keyof Picked, options: preact.ComponentChildren) => (
    <label>
      {label}{' '}
      <select
        aria-label={label}
        value={picked[field]}
        onChange={({ currentTarget }) => choose({ [field]: currentTarget.value })}
      >
        {options}
      </select>
    </label>
  );
  const mice = <Mice {...{ about, own, world }} />;
  const worlds = about.worlds.filter(({ plays }) => plays);
  return (
    <>
      <div class="choice">
        {select('Mouse', 'mouse', mice)}
        {select('Beside it', 'beside', [<option value="">nobody</option>, mice])}
        {select('Maze', 'maze', <Mazes {...{ about, mazes }} />)}
        {select(
          'World',
          'world',
          worlds.map((one) => <option value={one.name}>{one.name}</option>),
        )}
      </div>
      <Others own={own} {...others} />
    </>
  );
}

function usualPick(about: About): Picked {
  const maze = about.mazes.find(({ width }) => width === 16) ?? about.mazes[0];
  return { world: worldNamed(about, '').name, mouse: usualMouse, beside: '', maze: maze?.name ?? '' };
}

/** Takes a change; a mouse that does not run in that world is replaced by one that does. */
function change(picked: Picked, changes: Partial<Picked>, about: About) {
  Object.assign(picked, changes);
  const { mice, in_steps } = worldNamed(about, picked.world);
  const runs = (name: string) => mice.includes(name) || (in_steps && name.startsWith('own:'));
  if (!runs(picked.mouse)) picked.mouse = mice.includes(usualMouse) ? usualMouse : mice[0];
  if (!runs(picked.beside)) picked.beside = '';
}

const inWords = (settings: Fields | null) =>
  Object.entries(settings ?? {})
    .map((pair) => pair.join(' '))
    .join(', ');

/** Holds contests of any mouse in that maze; null where they were not `wanted` to their end. */
function createHolding({ core, about }: Page) {
  const cage = createCage();
  return async ({ world, mouse, beside }: Picked, maze: MazeData, settings: Fields | null, wanted: () => boolean) => {
    const plays: Shown[] = [];
    for (const one of [mouse, beside].filter(Boolean)) {
      const work = ownMice().find((work) => ownName(work) === one);
      const held = work
        ? await holdContest(core, cage, { ...work, program: work.text, maze, seed }, wanted)
        : await ours(core, worldNamed(about, world), one, maze, settings ?? {});
      if (!wanted()) return null;
      if (held) plays.push(held);
    }
    return plays;
  };
}

export type Chooser = ReturnType<typeof createChooser>;

/** `shown` hears of what was played, and whether somebody asked for just that; `draw` of all else that has changed. */
export function createChooser(
  page: Page,
  draw: () => void,
  shown: (plays: Shown[], asked: boolean, time?: number) => void,
) {
  const { core, about } = page;
  const hold = createHolding(page);
  const picked = usualPick(about);
  /** `unusual`: settings of the contest that are not the usual ones, until another world is chosen. */
  const state = { open: false, busy: false, mazes: [] as MazeData[], unusual: null as Fields | null };
  /** Counts up with each choice; what comes of an older one is not wanted. */
  let number = 0;
  function setBusy(is: boolean) {
    state.busy = is;
    draw();
  }
  /** `parts`: from where its mouse begins to err. */
  async function play(asked: boolean, parts = false) {
    const mine = ++number;
    const wanted = () => mine === number;
    setBusy(true);
    try {
      const [maze] = await mazesOf(core, [state.mazes.find(({ name }) => name === picked.maze) ?? picked.maze]);
      const plays = await hold({ ...picked }, maze, state.unusual, wanted);
      if (plays) shown(plays, asked, parts ? partingTime(plays[0].play) : undefined);
    } catch (error) {
      if (wanted()) page.complain(error);
    } finally {
      if (wanted()) setBusy(false);
    }
  }
  return {
    page,
    picked,
    state,
    choose(changes: Partial<Picked>) {
      change(picked, changes, about);
      if (changes.world !== undefined) state.unusual = null;
      void play(true);
    },
    part() {
      const { settings, seed, ...contest } = about.parting;
      Object.assign(picked, contest, { beside: '' });
      state.unusual = { ...settings, seed };
      void play(true, true);
    },
    play: () => play(false),
    /** Offers what there is by now; open while what is shown was chosen here. */
    refresh(open: boolean) {
      Object.assign(state, { mazes: namedApart(page.mazes(), about.mazes), open });
      draw();
    },
    /** What is shown came from elsewhere: a contest that still runs is not wanted any more. */
    forget() {
      number += 1;
      setBusy(false);
    },
  };
}

export const ContestChooser = ({ chooser: { page, picked, state, choose, part } }: { chooser: Chooser }) => (
  <details
    class="choices controls"
    open={state.open}
    aria-busy={state.busy || undefined}
    onToggle={({ currentTarget }) => (state.open = currentTarget.open)}
  >
    <summary>Choose a contest</summary>
    <div>
      <Form
        {...{ picked, choose, part, about: page.about, own: ownMice(), mazes: state.mazes }}
        conditions={inWords(state.unusual)}
        open={page.choose}
      />
    </div>
  </details>
);
