// The view Robot: the numbers of a robot, and at once what follows from them. It accepts robot files.
import type { MazeData } from '../core/types';
import { createMazeChoice } from '../choice/maze-choice';
import { myRobot, type KeptRobot, type Origin } from '../link/my-robot';
import { isSameMaze } from '../maze/same';
import type { Page, View } from '../page/page';
import { followRobot, keepRobot, reopenRobot, robotAddress } from '../robot/addresses';
import { createAsking, type Answers, type Question } from '../robot/asking';
import { createDraft, leaveLink, originOf, type Draft } from '../robot/draft';
import { createRobotForm } from '../robot/form';
import { createOutcome } from '../robot/outcome';
import { partSwitches } from '../robot/part-switch';
import { createRegions, type Regions } from '../robot/regions';
import { createRoutePanel } from '../robot/route-panel';
import { createStartCard } from '../robot/start-card';
import { h } from '../ui/dom';
import '../styles/forms.css';
import '../styles/robot.css';
import { errorText } from '../ui/format';

/** The parts of the view, and what they do to each other. */
function createParts(page: Page) {
  const { robot_keys: keys } = page.about;
  const draft = createDraft(page.about);
  const element = h('div.desk');
  const form = createRobotForm(keys, () => ask());
  const switches = partSwitches(page, draft, form, () => ask());
  const elements = switches.map((one) => one.element);
  const start = createStartCard(page, draft, elements, begin, () => ask());
  const route = createRoutePanel(page, draft, element, () => (draft.fresh ? draft.origin.name : start.name.value));
  const outcome = createOutcome(element, route);
  const subject = () =>
    draft.maze && !draft.refused ? { name: start.called(), values: draft.values, maze: draft.maze } : null;
  const regions = createRegions(page, keys, subject, () => (leaveLink(draft), keep()));
  const mazes = createMazeChoice(page, (maze) => {
    draft.maze = maze;
    ask(false);
  });
  const asking = createAsking(page, draft, form, answered, (error) => {
    outcome.rest();
    start.complain(errorText(error));
  });

  const keep = () => void keepRobot(page, draft, regions.question()).catch(page.complain);
  function ask(edited = true) {
    if (!draft.isShown) return;
    outcome.wait();
    if (edited) {
      draft.fresh = false;
      leaveLink(draft);
    }
    asking.ask({ name: start.called(), values: draft.fresh ? null : form.values(), maze: draft.maze });
  }
  function begin(from: Origin) {
    leaveLink(draft);
    Object.assign(draft, { origin: from, fresh: true, keys: [] });
    for (const part of switches) part.forget();
    start.show(from);
    ask(false);
  }
  function answered({ now, before }: Answers, { values, maze }: Question) {
    const isOrigin = values === null;
    outcome.rest();
    start.complain('');
    start.enable(now.result !== null);
    outcome.show(now, isOrigin ? null : before, form.say(now.problems, now.remarks));
    if (!now.result) showComplaint(form.element);
    else if (maze) route.show(isOrigin ? draft.origin.name : start.called(), now, isOrigin ? null : before.route, maze);
    for (const part of switches) part.show(now.values);
    regions.offer(now.values, maze);
    findWanted(page, draft, regions, maze);
    keep();
  }
  element.append(
    h('div.desk-side', outcome.refusal, start.element, mazes.element, form.element),
    route.room,
    outcome.element,
    regions.element,
  );
  return { page, draft, element, form, start, mazes, regions, ask, begin };
}

/** Finds the regions that a link asked for, once its maze is there. */
function findWanted(page: Page, draft: Draft, regions: Regions, maze: MazeData | null) {
  const { wanted } = draft;
  if (!maze || !wanted || (wanted.maze && !isSameMaze({ maze }, { maze: wanted.maze }))) return;
  draft.wanted = null;
  try {
    regions.find(wanted.varied);
  } catch (error) {
    page.complain(error);
  }
}

/** A field that is folded away is opened where something is wrong with it. */
function showComplaint(form: HTMLElement) {
  const closed = form.querySelector('[aria-invalid]')?.closest('details');
  if (closed) closed.open = true;
}

export function createRobot(page: Page): View {
  const desk = createParts(page);
  const { draft, mazes, regions, begin } = desk;
  return {
    element: h('section.robot', { 'aria-label': 'Robot' }, h('h2.unseen', 'Robot'), desk.element),
    maze: () => draft.maze,
    address: () => robotAddress(page, draft, regions.question()),
    follow: (hash) => followRobot(desk, hash),
    shown() {
      draft.isShown = true;
      // A robot that came with an address is edited from there.
      const mine = myRobot();
      if (mine !== null && mine !== draft.given) begin(originOf(mine));
      draft.given = mine;
      if (draft.maze) desk.ask(false);
      else mazes.refresh();
    },
    hidden() {
      draft.isShown = false;
    },
    accept(thing) {
      const robot = thing as KeptRobot;
      draft.given = myRobot();
      if (robot.origin) return void reopenRobot(desk, robot).catch(page.complain);
      draft.isShown = true;
      begin({ name: robot.name, text: robot.text });
    },
  };
}
