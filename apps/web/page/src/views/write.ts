// The view Write: a mouse is written, run in a maze, and raced against the roster.
import { Stopped } from '../core/client';
import type { MazeData, Play } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { mazeAt, placeOf } from '../link/mazes';
import { isSameMaze } from '../maze/same';
import { createPlayer } from '../player/player';
import { groupsOf } from '../results/contests';
import { mazesOf } from '../results/holding';
import { namedApart } from '../choice/picks';
import { leaderboard } from '../race/leaderboard';
import { routeOf } from '../link/routes';
import { h } from '../ui/dom';
import { holdContest, patience, type Held } from '../write/contest';
import { createDesk } from '../write/desk';
import type { Work } from '../write/keeping';
import { losses } from '../write/losses';
import { createPrints } from '../write/prints';
import { createRaceForm } from '../write/race-form';
import { raceProgram, type Raced, type Version } from '../write/racing';
import { createCage } from '../write/sandbox/cage';
import type { Page, View } from '../page/page';
import '../styles/forms.css';
import '../styles/write.css';

/** As `labmouse run` and `labmouse race` have it. */
const seed = 1;
const usualRuns = 20;
const usualMaze = 'capstone-1';

/** The line of the program in which it failed; null where it did not, or nobody knows. */
const failedAt = ({ ended }: Held) => (ended?.kind === 'failed' && ended.line) || null;

/** Why a contest was a forfeit; empty where nobody knows. */
function whyInWords({ play, ended, started }: Held): string {
  const [said] = play.last_words.split('\n');
  if (ended?.kind === 'silent' && !started)
    return `it did not begin within ${patience.start / 1000} s; is there a loop without an end outside of its steps?`;
  if (ended?.kind === 'failed')
    return `error${ended.line ? ` in line ${ended.line}` : ''}: ${ended.message.split('\n')[0]}`;
  if (ended?.kind === 'silent') return said.replace(/; does it flush.*/, '; is there a loop without an end?');
  return said;
}

/** What came of a contest, in a line, and of the one before it; of a program that did not begin, wherever it was. */
function outcomeInWords(held: Held, before?: Play): string {
  const { play } = held;
  if (!held.started) return `${play.mouse} did not start: ${whyInWords(held) || play.outcome}`;
  const where = `${play.mouse} in ${play.maze.name || 'this maze'}`;
  if (play.solved) {
    const was = before?.solved && before.score !== play.score && isSameMaze(before, play);
    const scores = `score ${play.score?.toFixed(3)}${was ? `, before ${before.score?.toFixed(3)}` : ''}`;
    return `${where}: solved, ${scores}; best possible ${play.bound?.toFixed(3) ?? 'none'}, lower is better`;
  }
  const why = whyInWords(held);
  return `${where}: ${play.outcome}${play.outcome.startsWith('forfeit') && why ? `; ${why}` : ''}`;
}

export function createWrite(page: Page): View {
  const cage = createCage();
  /** Counts up with each run and race; one whose number is past is no longer wanted. */
  let number = 0;

  /** What the player shows, and of which program. */
  let shown: { held: Held; text: string } | null = null;
  /** What the link says that the program came with, until it runs. */
  let linked: Moment | null = null;
  /** The maze of a link, which is none of the page's. */
  let foreign: MazeData | null = null;
  /** The program as it raced last, and as it was before it was changed. */
  let raced: Version | null = null;
  let before: Version | null = null;

  /** Links that are still being read. */
  let arriving = 0;
  let keptRun: Promise<unknown> | null = page.shelf.read('write');

  const changed = (allowed: boolean) => {
    stop();
    if (!allowed) clear();
    refresh();
    if (allowed && linked) void runIt(linked);
    linked = null;
    if (allowed || !desk.work()) return;
    // The program of a link is gone, so the address leads to it no longer.
    const route = routeOf(location.hash);
    if (route && 'program' in route) history.replaceState(null, '', '#write');
    void begin();
  };
  async function moment() {
    if (!shown) return '';
    const place = await placeOf(page.core, page.about, shown.held.play.maze);
    const same = shown.text === desk.work()?.text;
    return addressOf('', { ...place, ...(same && player.moment()) });
  }
  const controls = h('div', { class: 'desk-controls' });
  const desk = createDesk(page, changed, moment, controls);
  // Before the editor and the browser, which would write a line, and save the page.
  desk.element.addEventListener(
    'keydown',
    (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return;
      if (event.key === 'Enter') run.click();
      else if (event.key === 's') desk.save();
      else return;
      event.preventDefault();
      event.stopPropagation();
    },
    { capture: true },
  );
  const maze = h('select', {});
  const run = h('button', { type: 'button', class: 'main', onclick: () => void runIt() }, 'Run');
  const race = h('button', { type: 'button', onclick: () => void raceIt() }, 'Race');
  const end = h('button', { type: 'button', hidden: true, onclick: stop }, 'Stop');
  const verdict = h('p', { role: 'status', class: 'verdict', hidden: true });
  const bar = h('progress', { hidden: true, 'aria-label': 'Progress of the race' });
  const form = createRaceForm(page);
  const prints = createPrints((frame) => player.seek(frame));
  const player = createPlayer(page, prints);
  const standings = h('section', { class: 'race pictures standings', 'aria-label': 'Its race', hidden: true });
  const hint = h(
    'p',
    { class: 'note hint' },
    'Change the program, then run it in one maze and step through what it did, or race it against other mice.',
  );
  let mazes: { label: string; maze: string | MazeData }[] = [];

  function refresh() {
    const { mazes: builtin } = page.about;
    const own = namedApart(
      [...page.mazes(), ...(foreign ? [foreign] : [])],
      builtin.map(({ name }) => name),
    );
    const chosen = maze.value || usualMaze;
    mazes = [
      ...own.map((one) => ({ label: `${one.name} · yours`, maze: one })),
      ...builtin.map(({ name, width, height }) => ({ label: `${name} · ${width} × ${height}`, maze: name })),
    ];
    const nameOf = (one: string | MazeData) => (typeof one === 'string' ? one : one.name);
    maze.replaceChildren(...mazes.map((one) => h('option', { value: nameOf(one.maze) }, one.label)));
    if (mazes.some((one) => nameOf(one.maze) === chosen)) maze.value = chosen;
    form.refresh();
    run.disabled = race.disabled = desk.work() === null;
  }
  function stop() {
    number += 1;
    cage.close();
    page.core.stop('race');
    busy(false);
    // What was under way comes to no end.
    if (verdict.dataset.state === 'fair') verdict.hidden = true;
  }
  /** What ran here when the page was closed, once; null where nothing did. */
  async function ranBefore(): Promise<{ text: string; at: Moment } | null> {
    const kept = ((await keptRun) ?? {}) as { text?: unknown; at?: unknown };
    keptRun = null;
    if (typeof kept.text !== 'string' || typeof kept.at !== 'string') return null;
    const at = readAddress(kept.at).moment;
    await choose(at);
    return { text: kept.text, at };
  }
  /** A program to begin with shows at once what it does, and so does one that ran; what is new waits to be asked for. */
  async function begin() {
    const isIdle = () => arriving === 0 && end.hidden && player.element.hidden && desk.work() !== null;
    if (!isIdle()) return;
    // What lies there may be of any page.
    const ran = await ranBefore().catch(() => null);
    const work = desk.work();
    if (!work || !isIdle()) return;
    if (ran?.text === work.text) void runIt(ran.at);
    else if (work.language.templates.some(({ text }) => text === work.text)) void runIt();
  }
  const keepRun = async () => {
    if (shown) await page.shelf.write('write', { text: shown.text, at: `write${await moment()}` });
  };
  /** What was seen is of another program. */
  function clear() {
    shown = null;
    verdict.hidden = standings.hidden = true;
    hint.hidden = false;
    prints.show([]);
    player.show([]);
    desk.fail(null);
  }
  function busy(is: boolean) {
    end.hidden = !is;
    run.disabled = race.disabled = is || desk.work() === null;
    if (!is) bar.hidden = true;
  }
  function say(text: string, state: 'good' | 'bad' | 'fair') {
    verdict.hidden = false;
    verdict.dataset.state = state;
    verdict.replaceChildren(text);
  }
  /** What was asked for last stands first. */
  function show(held: Held, text: string, at?: Moment) {
    player.element.after(standings);
    hint.hidden = true;
    say(outcomeInWords(held, shown?.held.play), held.play.solved ? 'good' : 'bad');
    prints.show(held.prints);
    if (at?.time !== undefined) player.show([held], 'start', at.time, at.look);
    else player.show([held], 'end', 0, at?.look);
    shown = { held, text };
    desk.fail(failedAt(held));
    void keepRun();
  }
  /** Of a program that races nowhere there is nothing on the stage, and what was there is of another one. */
  function showNoStart(held: Held) {
    clear();
    say(outcomeInWords(held), 'bad');
    prints.show(held.prints);
    desk.fail(failedAt(held));
  }
  /** Does that with the program, and says what went wrong with it. */
  async function doing(act: (work: Work, wanted: () => boolean) => Promise<void>) {
    const work = desk.work();
    if (!work) return;
    if (work.name === '') return desk.complain('Give your mouse a name, by which the leaderboard can call it.');
    stop();
    const mine = ++number;
    busy(true);
    desk.complain('');
    desk.fail(null);
    try {
      await act(work, () => mine === number);
    } catch (error) {
      if (mine !== number || error instanceof Stopped) return;
      const message = error instanceof Error ? error.message : String(error);
      verdict.hidden = true;
      if (/\bname\b/.test(message)) desk.complain(message);
      else page.complain(error);
    } finally {
      if (mine === number) busy(false);
    }
  }
  const runIt = (at?: Moment) =>
    doing(async (work, wanted) => {
      say(`${work.name || 'It'} runs …`, 'fair');
      const [chosen] = await mazesOf(page.core, [mazes[maze.selectedIndex].maze]);
      const entry = { language: work.language, program: work.text, name: work.name, maze: chosen, seed };
      const held = await holdContest(page.core, cage, entry, wanted);
      if (!held) return;
      if (held.started) return show(held, work.text, at);
      showNoStart(held);
    });
  const raceIt = () =>
    doing(async (work, wanted) => {
      const chosen = form.mazes();
      if (chosen.length === 0) return page.complain('Choose at least one maze.');
      const runner = { language: work.language, program: work.text, name: work.name };
      const order = { mice: form.mice(), mazes: await mazesOf(page.core, chosen), runs: usualRuns, seed };
      bar.hidden = false;
      const report = ({ done, all, doing: what }: { done: number; all: number; doing: string }) => {
        if (!wanted()) return;
        bar.max = all;
        bar.value = done;
        say(`${what} …`, 'fair');
      };
      const changed = raced && (raced.runner.program !== work.text || raced.runner.language !== work.language);
      const last = changed ? raced : before;
      const race = await raceProgram(page.core, cage, runner, order, report, wanted, last);
      if (!race || !wanted()) return;
      if ('failed' in race) return showNoStart(race.failed);
      before = last;
      raced = race.now;
      showRace(race, work.text);
    });
  function showRace(raced: Raced, text: string) {
    const [group] = groupsOf(raced.results);
    const { contests } = raced.now;
    const name = contests[0].play.mouse;
    const old = raced.before?.contests[0].play.mouse;
    const place = (of: string) => group.mice.findIndex((mouse) => mouse.name === of) + 1;
    const solved = contests.filter(({ play }) => play.solved).length;
    const worst = contests.find(({ play }) => !play.solved);
    const than = old === undefined ? '' : `; ${old} is number ${place(old)}`;
    say(
      `${name} is number ${place(name)} of ${group.mice.length}: solved ${solved} of ${contests.length} mazes${than}`,
      solved === contests.length ? 'good' : 'bad',
    );
    standings.hidden = false;
    player.element.before(standings);
    standings.replaceChildren(
      h('h2', {}, 'Leaderboard'),
      leaderboard(group, () => undefined, old === undefined ? [name] : [name, old]).element,
      h('h2', {}, `What ${name} lost where`),
      losses(contests, (held) => {
        show(held, text);
        maze.value = held.play.maze.name;
        refresh();
        player.element.scrollIntoView();
      }),
      h(
        'p',
        { class: 'note' },
        'All of this race, with its pictures, stands in ',
        h('a', { href: '#race' }, 'Race'),
        '.',
      ),
    );
    page.hold(raced.results, raced.mazes, `The race of ${name} is over.`, undefined, raced.records);
    if (worst) desk.fail(failedAt(worst));
    standings.scrollIntoView({ block: 'nearest' });
  }
  async function arrive(link: string) {
    arriving += 1;
    await receive(link).catch(page.complain);
    arriving -= 1;
    void begin();
  }
  /** A program, and behind it where it was seen. */
  async function receive(link: string) {
    const [program, ...rest] = link.split('&');
    const { moment } = readAddress(['write', ...rest].join('&'));
    const chosen = await mazeAt(page.core, moment);
    await desk.receive(program);
    linked = moment;
    select(moment, chosen);
  }
  const choose = async (moment: Moment) => select(moment, await mazeAt(page.core, moment));
  /** Chooses the maze of a link. */
  function select(moment: Moment, chosen: MazeData | null) {
    if (!chosen) return;
    foreign = moment.builtin.length > 0 ? null : chosen;
    refresh();
    for (const [i, one] of mazes.entries()) {
      const same =
        typeof one.maze === 'string'
          ? one.maze === moment.builtin[0]
          : foreign && isSameMaze({ maze: one.maze }, { maze: foreign });
      if (same) maze.selectedIndex = i;
    }
  }
  controls.append(
    h('div', { class: 'row bar' }, h('label', {}, h('span', { class: 'unseen' }, 'Maze'), maze), run, race, end, bar),
    hint,
    verdict,
    prints,
    form.element,
  );
  player.rested(() => void keepRun());
  refresh();
  return {
    element: h(
      'section',
      { 'aria-label': 'Write', class: 'write' },
      h('h2', { class: 'unseen' }, 'Write a mouse'),
      desk.element,
      h('div', { class: 'bench' }, standings, player.element),
    ),
    shown() {
      refresh();
      void begin();
    },
    hidden: () => player.stop(),
    address: desk.address,
    accept(thing) {
      const { link, file } = thing as { link?: string; file?: File };
      if (link !== undefined) void arrive(link);
      if (file) void desk.open(file);
    },
  };
}
