// The view Robot: the numbers of a robot, and at once what follows from them. It accepts robot files.
import type { MazeData } from '../core/types';
import { createMazeChoice, MazeCard } from '../choice/maze-choice';
import { myRobot, type KeptRobot, type Origin } from '../link/my-robot';
import { isSameMaze } from '../maze/same';
import type { Page, View } from '../page/page';
import { followRobot, keepRobot, reopenRobot, robotAddress } from '../robot/addresses';
import { createAsking, type Answers, type Question } from '../robot/asking';
import { calledOf, createDraft, leaveLink, originOf, type Draft } from '../robot/draft';
import { createRobotForm, FormRoom } from '../robot/form';
import { createOutcome, OutcomeRoom, Refusal } from '../robot/outcome';
import { PartSwitches } from '../robot/part-switch';
import { createRegions, RegionsRoom, type Regions } from '../robot/regions';
import { createRoutePanel, RouteRoom, RouteTimes } from '../robot/route-panel';
import { StartCard } from '../robot/start-card';
import { createRoot } from '../ui/root';
import '../styles/forms.css';
import '../styles/robot.css';
import { errorText } from '../ui/format';

/** The parts of the view, and what they do to each other; `draw` is called after each change. */
function createDesk(page: Page, draw: () => void, complain: () => void) {
  const { robot_keys: keys } = page.about;
  const draft = createDraft(page.about);
  const state = { error: '' };
  const form = createRobotForm(keys, () => ask());
  const route = createRoutePanel();
  const outcome = createOutcome(draw);
  const subject = () =>
    draft.maze && !draft.refused ? { name: calledOf(draft), values: draft.values, maze: draft.maze } : null;
  const regions = createRegions(page, keys, subject, draw, () => (leaveLink(draft), keep()));
  const mazes = createMazeChoice(page, (maze) => ((draft.maze = maze), ask(false)), draw);
  const asking = createAsking(page, draft, form, answered, (error) => {
    outcome.rest();
    state.error = errorText(error);
    draw();
  });

  const keep = () => void keepRobot(page, draft, regions.question()).catch(page.complain);
  function ask(edited = true) {
    draw();
    if (!draft.isShown) return;
    outcome.wait();
    if (edited) {
      draft.fresh = false;
      leaveLink(draft);
    }
    asking.ask({ name: calledOf(draft), values: draft.fresh ? null : form.values(), maze: draft.maze });
  }
  function begin(from: Origin) {
    leaveLink(draft);
    Object.assign(draft, { origin: from, fresh: true, keys: [] });
    if (from.text !== null) draft.name = from.name;
    ask(false);
  }
  function answered({ now, before }: Answers, { values, maze }: Question) {
    const isOrigin = values === null;
    outcome.rest();
    state.error = '';
    outcome.show(now, isOrigin ? null : before, form.say(now.problems, now.remarks));
    if (now.result && maze) {
      const origin = draft.origin.name;
      const called = isOrigin ? origin : calledOf(draft);
      const was = isOrigin ? null : before.route;
      route.show({ called, origin, maze, route: now.route, reason: now.no_route ?? '', was });
    }
    regions.offer(now.values, maze);
    draw();
    if (!now.result) complain();
    findWanted(page, draft, regions, maze);
    keep();
  }
  return { page, draft, state, form, route, outcome, regions, mazes, ask, begin };
}

function Desk({ desk }: { desk: ReturnType<typeof createDesk> }) {
  const { page, draft, state, form, route, outcome, regions, mazes, ask, begin } = desk;
  const isStale = outcome.state.refused !== '';
  function rename(name: string) {
    draft.name = name;
    ask();
  }
  return (
    <div
      class="desk"
      aria-busy={outcome.state.isBusy || undefined}
      ref={(element) => void element?.classList.toggle('stale', isStale)}
    >
      <div class="desk-side">
        <Refusal outcome={outcome} />
        <StartCard {...{ page, draft, begin, rename }} error={state.error}>
          <PartSwitches key={draft.origin} {...{ page, draft, form }} changed={() => ask()} />
        </StartCard>
        <MazeCard choice={mazes} />
        <FormRoom form={form} />
      </div>
      <RouteRoom panel={route} />
      <OutcomeRoom outcome={outcome}>
        <RouteTimes panel={route} page={page} robot={draft.fresh ? draft.origin.name : draft.name} />
      </OutcomeRoom>
      <RegionsRoom regions={regions} />
    </div>
  );
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
function showComplaint(view: HTMLElement) {
  const closed = view.querySelector('.robot-form [aria-invalid]')?.closest('details');
  if (closed) closed.open = true;
}

export function createRobot(page: Page): View {
  const { element, draw } = createRoot('robot', 'Robot', () => (
    <>
      <h2 class="unseen">Robot</h2>
      <Desk desk={desk} />
    </>
  ));
  const desk = createDesk(page, draw, () => showComplaint(element));
  const { draft, mazes, regions, begin } = desk;
  draw();
  return {
    element,
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
