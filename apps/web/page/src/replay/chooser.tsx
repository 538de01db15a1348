// Which contest is played: one of our mice or of the user's own, in any maze, alone or beside another.
import { render } from 'preact';
import type { Core } from '../core/client';
import type { About, Fields, MazeData, Play, WorldInPage } from '../core/types';
import { namedApart } from '../choice/picks';
import { mazesOf } from '../results/holding';
import { calledOf } from '../results/worlds';
import { h } from '../ui/dom';
import type { Page } from '../page/page';
import { holdContest } from '../write/contest';
import type { Work } from '../write/keeping';
import { kept } from '../write/stored';
import { languages } from '../write/languages';
import { createCage } from '../write/sandbox/cage';
import type { Shown } from '../player/side';

export interface Picked {
  world: string;
  mouse: string;
  /** The mouse beside it; empty for none. */
  beside: string;
  maze: string;
}

export interface Chooser {
  element: HTMLElement;
  /** Plays what is chosen. */
  play(): Promise<void>;
  /** Offers what there is by now; open while what is shown was chosen here. */
  refresh(open: boolean): void;
  /** What is shown came from elsewhere: a contest that still runs is not wanted any more. */
  forget(): void;
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

/** A world in which single contests are held, by its name; the home world where it is none. */
export const worldNamed = ({ worlds }: About, name: string): WorldInPage =>
  worlds.find((one) => one.name === name && one.call) ?? worlds.find(({ home }) => home)!;

/** A contest of a mouse of ours. */
const ours = (core: Core, world: WorldInPage, mouse: string, maze: MazeData, settings = {}) =>
  core.call(world.call!, {
    ...{ mouse, maze, seed, ...usualSettings(world) },
    ...(world.call === 'contest' && { world: world.name }),
    ...settings,
  } as never) as Promise<Shown>;

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

export function Form({ picked, about, own, mazes, choose, open, part, conditions }: FormProps) {
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
  const mice = (
    <>
      {world.home && own.length > 0 && (
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
  return (
    <>
      <div class="choice">
        {select('Mouse', 'mouse', mice)}
        {select(
          'Beside it',
          'beside',
          <>
            <option value="">nobody</option>
            {mice}
          </>,
        )}
        {select(
          'Maze',
          'maze',
          <>
            {mazes.map(({ name }) => (
              <option value={name}>{name}, yours</option>
            ))}
            {about.mazes.map(({ name, width, height }) => (
              <option value={name}>
                {name}, {width} × {height}
              </option>
            ))}
          </>,
        )}
        {select(
          'World',
          'world',
          about.worlds.filter(({ call }) => call).map((world) => <option value={world.name}>{calledOf(world)}</option>),
        )}
      </div>
      <p class="note">
        Real mice err:{' '}
        <button type="button" onClick={part}>
          Watch belief and truth part
        </button>{' '}
        and come together again.{conditions && ` Here: ${conditions}.`}
      </p>
      <p class="note">
        {own.length === 0 && (
          <>
            <a href="#write">Write a mouse</a> of your own, and it stands here, too.{' '}
          </>
        )}
        A record holds a contest step by step: drop one anywhere on this page, or{' '}
        <button type="button" onClick={open}>
          Open a record
        </button>
        . They are written by <code>labmouse run MOUSE MAZE --record FILE</code>, by races with <code>--out DIR</code>,
        by programs for mms, and by real robots; with <code>--explain</code> they also say why ariadne went where it
        did.
      </p>
    </>
  );
}

/** `shown` hears of what was played, and whether somebody asked for just that. */
export function createChooser(page: Page, shown: (plays: Shown[], asked: boolean, time?: number) => void): Chooser {
  const { core, about } = page;
  const cage = createCage();
  const room = h('div', {});
  const element = h('details', { class: 'choices controls' }, h('summary', {}, 'Choose a contest'), room);
  const usualMaze = about.mazes.find(({ width }) => width === 16) ?? about.mazes[0];
  const picked: Picked = { world: '', mouse: usualMouse, beside: '', maze: usualMaze?.name ?? '' };
  picked.world = worldNamed(about, '').name;
  /** Settings of the contest that are not the usual ones, until another world is chosen. */
  let unusual: Fields | null = null;
  /** Counts up with each choice; what comes of an older one is not wanted. */
  let number = 0;
  let mazes: MazeData[] = [];

  function draw() {
    const own = ownMice();
    const choose = (change: Partial<Picked>) => {
      Object.assign(picked, change);
      if (change.world !== undefined) unusual = null;
      const { mice, home } = worldNamed(about, picked.world);
      const runs = (name: string) => mice.includes(name) || (home && name.startsWith('own:'));
      if (!runs(picked.mouse)) picked.mouse = mice.includes(usualMouse) ? usualMouse : mice[0];
      if (!runs(picked.beside)) picked.beside = '';
      draw();
      void play(true);
    };
    render(
      <Form
        {...{ picked, about, own, mazes, choose }}
        open={() => page.choose()}
        part={part}
        conditions={
          unusual
            ? Object.entries(unusual)
                .map((pair) => pair.join(' '))
                .join(', ')
            : ''
        }
      />,
      room,
    );
  }
  async function contest(mouse: string, maze: MazeData, wanted: () => boolean): Promise<Shown | null> {
    const work = ownMice().find((one) => ownName(one) === mouse);
    if (!work) return ours(core, worldNamed(about, picked.world), mouse, maze, unusual ?? {});
    const { language, text: program, name } = work;
    return holdContest(core, cage, { language, program, name, maze, seed }, wanted);
  }
  function part() {
    const { settings, seed, ...contest } = about.parting;
    Object.assign(picked, contest, { beside: '' });
    unusual = { ...settings, seed };
    draw();
    void play(true, true);
  }
  /** `parts`: from where its mouse begins to err. */
  async function play(asked: boolean, parts = false) {
    const mine = ++number;
    const wanted = () => mine === number;
    element.setAttribute('aria-busy', 'true');
    try {
      const [maze] = await mazesOf(core, [mazes.find(({ name }) => name === picked.maze) ?? picked.maze]);
      const plays: Shown[] = [];
      for (const mouse of [picked.mouse, picked.beside]) {
        const held = mouse === '' ? null : await contest(mouse, maze, wanted);
        if (!wanted()) return;
        if (held) plays.push(held);
      }
      shown(plays, asked, parts ? partingTime(plays[0].play) : undefined);
    } catch (error) {
      if (wanted()) page.complain(error);
    } finally {
      if (wanted()) rest();
    }
  }
  const rest = () => element.removeAttribute('aria-busy');
  return {
    element,
    play: () => play(false),
    refresh(open) {
      mazes = namedApart(
        page.mazes(),
        about.mazes.map(({ name }) => name),
      );
      element.open = open;
      draw();
    },
    forget() {
      number += 1;
      rest();
    },
  };
}
