// The view Replay: the player, and while there is nothing to show, how to get something.
import type { MazeData } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { contestBehind, contestOf, contestsInMoment, contestsOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import type { Camera } from '../maze/camera';
import { isSameMaze } from '../maze/same';
import { h } from '../ui/dom';
import { createBeside } from '../player/beside';
import { createPlayer } from '../player/player';
import type { Shown } from '../player/side';
import '../styles/replay.css';
import type { Page, View } from './view';

type Run = (mouse: string, maze: MazeData) => Promise<Shown>;

/** Runs mice in a maze that the core brings, as an example. */
function createExample(page: Page, mice: string[], where: string, run: Run) {
  const { mazes } = page.about;
  const select = h(
    'select',
    {},
    ...mazes.map(({ name, width, height }) => h('option', { value: name }, `${name} (${width} × ${height})`)),
  );
  const usual = mazes.find(({ width }) => width === 16) ?? mazes[0];
  if (usual) select.value = usual.name;
  async function show() {
    page.tell(`${mice.join(' and ')} in ${select.value} …`);
    try {
      const { maze } = await page.core.call('builtin_maze', { name: select.value });
      const plays: Shown[] = [];
      for (const mouse of mice) plays.push(await run(mouse, maze));
      page.tell('');
      page.replay(plays);
    } catch (error) {
      page.complain(error);
    }
  }
  return h(
    'p',
    {},
    h('label', {}, `${mice.join(' and ')}${where} in `, select),
    ' ',
    h('button', { type: 'button', onclick: () => void show() }, 'Run'),
  );
}

function createWelcome(page: Page) {
  const inSteps: Run = (mouse, maze) => page.core.call('run', { mouse, maze, seed: 1 });
  const { robots, drive_rules: rules } = page.about;
  const inSeconds: Run = (mouse, maze) =>
    page.core.call('drive', { mouse, maze, seed: 1, robot: robots[0].name, rules: rules[0].name });
  return h(
    'div',
    { class: 'welcome sheet' },
    h(
      'p',
      {},
      'A record holds a contest step by step: what the mouse read, what it did, and where that led. ',
      'Here you can replay it.',
    ),
    h('h3', {}, 'See an example'),
    createExample(page, ['ariadne'], '', inSteps),
    createExample(page, ['ariadne', 'flood'], '', inSteps),
    robots.length > 0 && rules.length > 0 && createExample(page, ['certify'], ' in seconds', inSeconds),
    h('h3', {}, 'See one of your own'),
    h(
      'p',
      {},
      h('button', { type: 'button', onclick: () => page.choose() }, 'Open a record'),
      ' or drop one anywhere on this page.',
    ),
    h(
      'p',
      { class: 'note' },
      'Records are written by ',
      h('code', {}, 'labmouse run MOUSE MAZE --record FILE'),
      ', by races with ',
      h('code', {}, '--out DIR'),
      ', by programs for mms, and by real robots; with ',
      h('code', {}, '--explain'),
      ' they also say why ariadne went where it did. In the view Race, click a contest to open its record here.',
    ),
  );
}

export function createReplay(page: Page): View {
  const another = h('button', { type: 'button', onclick: () => show([]) }, 'Another record');
  const beside = createBeside(page, (plays) => show(plays));
  const player = createPlayer(page, h('div', { class: 'row another' }, another, beside.element));
  /** A link that was followed goes along, so that a reload of the page leads to this moment. */
  player.rested(() => {
    const now = player.moment();
    page.keepMoment(addressOf('replay', now));
    if (!linked || element.hidden || !location.hash.startsWith('#replay&')) return;
    history.replaceState(null, '', `#${addressOf('replay', { ...linked, ...now })}`);
  });
  const welcome = createWelcome(page);
  player.element.tabIndex = -1;
  player.element.setAttribute('role', 'group');
  player.element.setAttribute('aria-label', 'Player');
  const element = h(
    'section',
    { class: 'replay', 'aria-label': 'Replay' },
    h('h2', { class: 'unseen' }, 'Replay'),
    welcome,
    player.element,
  );
  let now: Shown[] = [];
  /** What the link says that led here; null where none did. */
  let linked: Moment | null = null;
  function show(plays: Shown[], time?: number, look?: Camera) {
    now = plays;
    linked = null;
    welcome.hidden = plays.length > 0;
    player.show(plays, 'start', time, look);
    beside.show(plays);
    // The button that was pressed is gone; the keys are the player's now.
    if (plays.length > 0) player.element.focus({ preventScroll: true });
    else welcome.querySelector('select')?.focus();
  }
  return {
    element,
    shown() {},
    hidden: () => player.stop(),
    accept(thing) {
      const { plays, time, look } = thing as { plays: Shown[]; time?: number; look?: Camera };
      show(plays, time, look);
    },
    async address() {
      if (now.length === 0) return 'replay';
      const { core, about } = page;
      const plays = now.slice(0, 2).map(({ play }) => play);
      const contests = [];
      for (const play of plays) contests.push(await contestBehind(core, play));
      const conditions = contests.map(({ budget, drive }) => JSON.stringify([budget, drive]));
      if (!plays.every((play) => isSameMaze(play, plays[0])) || new Set(conditions).size > 1)
        throw new Error('A link holds contests in one maze under the same conditions. Send the records instead.');
      const place = await placeOf(core, about, plays[0].maze);
      return addressOf('replay', { ...contestsInMoment(contests, about), ...place, ...player.moment() });
    },
    async follow(hash) {
      const { moment } = readAddress(hash);
      const maze = await mazeAt(page.core, moment);
      if (!maze || moment.mice.length < 1 || moment.mice.length > 2)
        throw new Error('This link cannot be followed: a replay is of one or two mice in a maze.');
      const plays: Shown[] = [];
      for (const contest of contestsOf(moment, page.about, maze)) plays.push(await contestOf(page.core, contest));
      page.keepPlays(plays);
      show(plays, moment.time, moment.look);
      linked = moment;
    },
  };
}
