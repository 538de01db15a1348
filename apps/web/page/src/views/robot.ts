// The view Robot: the numbers of a robot, and at once what follows from them. It accepts robot files.
import type { MazeData, RobotAnswer, RobotResult } from '../core/types';
import { addressOf, readAddress, type Moment } from '../link/address';
import { driveOf } from '../link/contest';
import { mazeAt, placeOf } from '../link/mazes';
import { createMazeChoice } from '../choice/maze-choice';
import { isSameMaze } from '../maze/same';
import { routeTable, searchTable, straightTables, turnFigures } from '../robot/figures';
import { pngOf, svgOf } from '../maze/saved';
import { createLooks } from '../player/looks';
import { createRobotForm, type Values } from '../robot/form';
import { hasTimes, keysBeside, withLimits, withTimes, type Part } from '../robot/forms';
import { createRegions, type Question as Varied } from '../robot/regions';
import { isMine, myRobot, nameOf, setMyRobot, withoutRemarks, type KeptRobot, type Origin } from '../link/my-robot';
import { createRouteStage } from '../robot/route-stage';
import { h } from '../ui/dom';
import { complainAt, field } from '../ui/field';
import { createLatest } from '../ui/latest';
import { meanings } from '../ui/meanings';
import { turnMeanings } from '../ui/terms';
import type { Page, View } from '../page/page';
import '../styles/forms.css';
import '../styles/robot.css';

interface Question {
  name: string;
  /** Null: as it began. */
  values: Values | null;
  maze: MazeData | null;
}

/** After so many milliseconds the page says that it is at work. */
const patience = 100;

export function createRobot(page: Page): View {
  const { robots, robot_keys: keys } = page.about;
  let origin: Origin = { name: robots[0]?.name ?? '', text: null };
  let began: Promise<RobotAnswer> | null = null;
  let beganFor: MazeData | null = null;
  let maze: MazeData | null = null;
  let fileText = '';
  /** What this view gave to the others last. */
  let given: string | null = null;
  /** What followed from the last robot that could be. */
  let result: RobotResult | null = null;
  /** Whether the last robot that was asked for can be none. */
  let refused = false;
  /** The numbers of the robot that stands there. */
  let nowValues: Values = {};
  /** Whether it stands as it came with a link: then that of this browser is kept. */
  let linked = false;
  /** Which regions a link asks for, and in which maze (null: in any), until that is shown. */
  let wanted: { varied: Varied; maze: MazeData | null } | null = null;
  let isShown = false;
  let late: ReturnType<typeof setTimeout> | undefined;

  const select = h(
    'select',
    { onchange: () => begin({ name: select.value, text: null }) },
    ...robots.map(({ name, cell }) => h('option', { value: name }, `${name}, cells of ${cell} mm`)),
  );
  const opened = h('option', { value: '', hidden: true }, 'a file');
  select.append(opened);
  const usual = robots.find(({ name }) => name === 'classic');
  if (usual) select.value = origin.name = usual.name;
  const name = h('input', { type: 'text', value: 'my-mouse', spellcheck: 'false', oninput: () => ask() });
  const nameRow = field('Name', name);
  const form = createRobotForm(keys, () => ask());
  const status = h('p', { class: 'verdict', role: 'status' });
  // Stays in sight while the form scrolls.
  const refusal = h('p', { class: 'refusal', role: 'alert' });
  const others = h('ul', { class: 'robot-sentences' });
  const stage = createRouteStage();
  const regions = createRegions(
    page,
    keys,
    () => (maze && !refused ? { name: robotName(), values: nowValues, maze } : null),
    () => (leaveLink(), void keep().catch(page.complain)),
  );
  const routeTimes = h('div', {});
  const turns = h('div', { class: 'robot-turns' });
  const tables = h('div', { class: 'robot-tables' });
  const follows = h('div', { class: 'robot-follows' });
  const caption = h('span', { class: 'robot-line' });
  const desk = h('div', { class: 'desk' });
  const room = h(
    'figure',
    { class: 'robot-room' },
    h('figcaption', {}, caption, createLooks(stage.stage, desk)),
    stage.stage.element,
  );
  const mazes = createMazeChoice(page, (next) => {
    maze = next;
    ask(false);
  });
  const tell = (message: string) => page.tell(message);
  const save = h(
    'button',
    { type: 'button', onclick: () => page.save(`${nameOf(name.value) || 'robot'}.toml`, fileText, 'application/toml') },
    'Save as TOML',
  );
  const use = (view: 'live' | 'race') =>
    h(
      'button',
      {
        type: 'button',
        onclick: () => {
          location.hash = view;
          tell(`${name.value} can be chosen under Robot, in the world of seconds.`);
        },
      },
      view === 'live' ? 'Drive it in Live' : 'Race with it',
    );
  const saved = (ending: 'png' | 'svg') => `${fresh ? origin.name : name.value}-${maze?.name || 'route'}.${ending}`;
  async function savePng() {
    const { g, paint } = stage.picture();
    page.save(saved('png'), await pngOf(g, paint), 'image/png');
  }
  function saveSvg() {
    const { g, paint } = stage.picture();
    page.save(saved('svg'), svgOf(g, paint), 'image/svg+xml');
  }
  const uses = [save, use('live'), use('race')];

  const bytesOf = ({ text }: Origin): [Uint8Array?] => (text === null ? [] : [new TextEncoder().encode(text)]);
  const builtIn = ({ name, text }: Origin) => (text === null ? { built_in: name } : {});

  /** The robot that it began from, in this maze. */
  function beginning(where: MazeData | null): Promise<RobotAnswer> {
    if (!began || beganFor !== where) {
      beganFor = where;
      began = page.core.call(
        'robot',
        { name: origin.name, ...builtIn(origin), ...(where && { maze: where }) },
        ...bytesOf(origin),
      );
    }
    return began;
  }
  const latest = createLatest(
    async ({ name, values, maze }: Question) => {
      const before = await beginning(maze);
      if (values === null) return { now: before, before };
      return { now: await page.core.call('robot', { name, values, ...(maze && { maze }) }), before };
    },
    ({ now, before }, { name: called, values, maze }) => {
      rest();
      // A form that is being edited is left alone.
      if (values === null) form.show(now.values, now.keys);
      else if (JSON.stringify(now.keys) !== JSON.stringify(shownKeys)) form.show(now.values, now.keys);
      shownKeys = now.keys;
      show(now, before, maze, values === null);
      fileText = now.text;
      refused = now.result === null;
      const isSame = now.result?.tables === before.result?.tables && origin.text === null;
      given = now.result && !isSame ? `${called}\n${now.text}` : null;
      setMyRobot(given);
      for (const part of parts) part.show(now.values);
      nowValues = now.values;
      regions.offer(now.values, maze);
      if (maze && wanted && (!wanted.maze || isSameMaze({ maze }, { maze: wanted.maze }))) findWanted(wanted.varied);
      void keep().catch(page.complain);
    },
    (error) => {
      rest();
      complainAt({ name: nameRow }, 'name', error instanceof Error ? error.message : String(error));
    },
  );
  let shownKeys: string[] = [];
  function findWanted(varied: Varied) {
    wanted = null;
    try {
      regions.find(varied);
    } catch (error) {
      page.complain(error);
    }
  }
  /** For when the page is opened again: an edited robot with what it began from, and what is asked of it in which maze. */
  async function keep() {
    if (linked || refused || !maze) return;
    await page.shelf.write('robot', given && { ...originOf(given), origin });
    const robot = given === null && origin.text === null ? { robot: origin.name } : {};
    const place = await placeOf(page.core, page.about, maze);
    await page.shelf.write('robot-at', `#${addressOf('robot', { ...place, ...robot, ...regions.question() })}`);
  }

  /** Limits of a robot that has them, in cells of that size where there is one. */
  async function limitsOf(part: Part, cell: unknown): Promise<Values> {
    const others = [...robots].sort((a, b) => Number(b.cell === cell) - Number(a.cell === cell));
    for (const { name } of others) {
      const { values } = await page.core.call('robot', { name, built_in: name });
      if (!hasTimes(values, keys, part)) return values;
    }
    return {};
  }
  /** How a part of the robot is given, and a switch between the two ways. */
  function createPart(part: Part, label: string, help: string) {
    const select = h(
      'select',
      { onchange: () => void change().catch(page.complain) },
      h('option', { value: 'limits' }, 'as limits'),
      h('option', { value: 'times' }, 'as published times'),
    );
    /** The limits that the last change took away. */
    let limits: Values | null = null;
    async function change() {
      const values = form.values();
      if (select.value === 'times') limits = values;
      if (select.value === 'times' && !result) return;
      const next =
        select.value === 'times'
          ? withTimes(values, keys, part, result!)
          : withLimits(values, keys, part, limits ?? (await limitsOf(part, values.cell)));
      form.show(next, keysBeside(next, keys));
      ask();
    }
    return {
      element: field(label, select, h('span', {}, help)),
      show: (values: Values) => (select.value = hasTimes(values, keys, part) ? 'times' : 'limits'),
      forget: () => (limits = null),
    };
  }
  const parts = [
    createPart('turns', 'Turns are given', 'limits of its curves, or one speed and the time of each turn'),
    createPart('search', 'The search is given', 'a speed and its pivots, or the time of each move'),
  ];

  const robotName = () => name.value.trim().replaceAll('\n', ' ') || 'robot';
  function rest() {
    clearTimeout(late);
    desk.removeAttribute('aria-busy');
  }
  function ask(edited = true) {
    if (!isShown) return;
    clearTimeout(late);
    late = setTimeout(() => {
      desk.setAttribute('aria-busy', 'true');
      status.replaceChildren('Computing …');
      status.dataset.state = 'fair';
    }, patience);
    if (edited) {
      fresh = false;
      leaveLink();
    }
    latest.ask({ name: robotName(), values: fresh ? null : form.values(), maze });
  }
  /** What the address leads to is no longer what is shown. */
  function leaveLink() {
    if (linked && isShown) history.replaceState(null, '', '#robot');
    linked = false;
  }
  /** Nothing has been edited since it began. */
  let fresh = true;
  function begin(from: Origin) {
    leaveLink();
    origin = from;
    began = null;
    fresh = true;
    shownKeys = [];
    for (const part of parts) part.forget();
    opened.hidden = from.text === null;
    opened.textContent = from.name;
    select.value = from.text === null ? from.name : '';
    if (from.text !== null) name.value = from.name;
    ask(false);
  }

  const originOf = (robot: string): Origin => ({
    name: nameOf(robot),
    text: isMine(robot) ? robot.slice(nameOf(robot).length + 1) : null,
  });
  async function address() {
    if (refused) throw new Error('A link cannot hold this robot, for it is refused: mend its numbers first.');
    const robot = given ?? (origin.text === null ? origin.name : `${origin.name}\n${origin.text}`);
    return addressOf('robot', {
      ...(maze && (await placeOf(page.core, page.about, maze))),
      robot: withoutRemarks(robot),
      ...regions.question(),
    });
  }
  async function follow(hash: string) {
    const { moment } = readAddress(hash);
    if (moment.and && !moment.vary)
      throw new Error('This link cannot be followed: it varies a second number and no first one.');
    const robot = moment.robot && driveOf({ robot: moment.robot }, page.about)?.with.robot;
    const where = await mazeAt(page.core, moment);
    if (robot) begin(originOf(robot));
    linked = true;
    goTo(moment, where);
  }
  /** To that maze, if any, and the regions that are asked for there. */
  function goTo(moment: Moment, where: MazeData | null) {
    wanted = moment.vary ? { varied: { vary: moment.vary, and: moment.and }, maze: where } : null;
    if (where && moment.builtin.length > 0) mazes.choose(moment.builtin[0]);
    else if (where) mazes.give(where);
  }

  /** A robot that was edited before the page was opened again, with what it began from, and where it was. */
  async function reopen({ name: called, text, origin: from = { name: called, text }, at }: KeptRobot) {
    begin(from);
    name.value = called;
    const edited = await page.core.call('robot', { name: called }, new TextEncoder().encode(text));
    form.show(edited.values, edited.keys);
    shownKeys = edited.keys;
    fresh = false;
    given = myRobot();
    ask();
    if (!at) return;
    const { moment } = readAddress(at);
    goTo(moment, await mazeAt(page.core, moment));
  }

  function showRoute(called: string, { route, no_route }: RobotAnswer, before: RobotAnswer, where: MazeData | null) {
    if (!where) return;
    const was = before.route;
    if (!route) {
      stage.show(where, null, null, `${where.name}, without a route`);
      caption.replaceChildren(h('strong', {}, where.name), ' without a route');
      return routeTimes.replaceChildren(h('p', { class: 'note' }, no_route && `${where.name} ${no_route}`));
    }
    const other = was && was.route !== route.route ? was.path : null;
    const time = `${(route.time_us / 1e6).toFixed(3)} s`;
    const faster = was && was.time_us !== route.time_us ? `, ${origin.name} ${(was.time_us / 1e6).toFixed(3)} s` : '';
    caption.replaceChildren(
      h('strong', {}, `${called} in ${where.name}: ${time}`),
      ` from rest to the centre of the goal${faster}`,
    );
    stage.show(where, route.path, other, `The best route of ${where.name}: ${time}`);
    routeTimes.replaceChildren(
      routeTable(route, was),
      h(
        'p',
        { class: 'note' },
        other
          ? `Another way than that of ${origin.name}, which is the broken line.`
          : was && `The same way as that of ${origin.name}.`,
      ),
      h('details', {}, h('summary', {}, 'Piece by piece'), h('p', { class: 'notation' }, route.route)),
    );
  }
  function show(now: RobotAnswer, before: RobotAnswer, where: MazeData | null, isOrigin: boolean) {
    complainAt({ name: nameRow }, 'name', '');
    const rest = form.say(now.problems, now.remarks);
    others.replaceChildren(...rest.map(({ text }) => h('li', {}, text)));
    others.hidden = rest.length === 0;
    desk.classList.toggle('stale', now.result === null);
    for (const button of uses) button.disabled = now.result === null;
    status.dataset.state = now.result === null ? 'bad' : now.remarks.length > 0 ? 'fair' : 'good';
    const refused = now.result ? '' : `Refused: ${now.problems[0]?.text ?? 'no robot'}`;
    status.replaceChildren(now.result?.line ?? refused);
    if (refusal.textContent !== refused) refusal.replaceChildren(refused);
    // What is shown below stays that of the last robot that could be.
    if (!now.result) return showComplaint();
    result = now.result;
    const was = isOrigin ? null : before.result;
    showRoute(isOrigin ? origin.name : robotName(), now, isOrigin ? { ...before, route: null } : before, where);
    turns.replaceChildren(...turnFigures(now.result, was));
    tables.replaceChildren(
      ...straightTables(now.result, was),
      h('div', {}, h('h4', {}, 'Moves of a search'), searchTable(now.result, was)),
    );
  }
  /** A field that is folded away is opened where something is wrong with it. */
  function showComplaint() {
    const closed = form.element.querySelector('[aria-invalid]')?.closest('details');
    if (closed) closed.open = true;
  }

  const start = h(
    'section',
    { class: 'card', 'aria-label': 'Start from' },
    h('h2', {}, 'My robot'),
    field('Start from', select, h('span', {}, 'the robot that all changes are compared with')),
    nameRow,
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', onclick: () => begin({ ...origin }) }, 'Undo all changes'),
      h('button', { type: 'button', onclick: () => page.choose() }, 'Open a TOML file'),
    ),
    h('div', { class: 'row' }, ...uses),
    ...parts.map(({ element }) => element),
  );
  follows.append(
    h('div', {}, h('h3', {}, 'The best route'), routeTimes),
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', onclick: () => void savePng().catch(page.complain) }, 'Save route (PNG)'),
      h('button', { type: 'button', onclick: saveSvg }, 'Save route (SVG)'),
    ),
    h('h3', {}, 'Turns'),
    turns,
    meanings(turnMeanings),
    h('h3', {}, 'Straights and the search'),
    tables,
  );
  desk.append(
    h('div', { class: 'desk-side' }, refusal, start, mazes.element, form.element),
    room,
    h('div', { class: 'desk-main' }, status, others, follows),
    regions.element,
  );
  return {
    element: h('section', { 'aria-label': 'Robot', class: 'robot' }, h('h2', { class: 'unseen' }, 'Robot'), desk),
    maze: () => maze,
    address,
    follow,
    shown() {
      isShown = true;
      // A robot that came with an address is edited from there.
      const mine = myRobot();
      if (mine !== null && mine !== given) begin(originOf(mine));
      given = mine;
      if (maze) ask(false);
      else mazes.refresh();
    },
    hidden() {
      isShown = false;
    },
    accept(thing) {
      const robot = thing as KeptRobot;
      given = myRobot();
      if (robot.origin) return void reopen(robot).catch(page.complain);
      isShown = true;
      begin({ name: robot.name, text: robot.text });
    },
  };
}
