// The best route of the maze: on a stage, and its times, beside those of the robot that it began from.
import type { MazeData, RobotAnswer, RobotRoute } from '../core/types';
import { savePicture } from '../maze/saved';
import type { Page } from '../page/page';
import { createLooks } from '../player/looks';
import { button } from '../ui/controls';
import { h } from '../ui/dom';
import type { Draft } from './draft';
import { routeTable } from './figures';
import { createRouteStage } from './route-stage';

export type RoutePanel = ReturnType<typeof createRoutePanel>;

const seconds = ({ time_us }: RobotRoute) => `${(time_us / 1e6).toFixed(3)} s`;

/** `desk` is what fills the screen; files are called as `robot` says. */
export function createRoutePanel(page: Page, draft: Draft, desk: HTMLElement, robot: () => string) {
  const stage = createRouteStage();
  const caption = h('span.robot-line');
  const times = h('div');
  const looks = createLooks(stage.stage, desk);
  const save = (ending: 'png' | 'svg') =>
    savePicture(page.save, `${robot()}-${draft.maze?.name || 'route'}`, ending, stage.picture()).catch(page.complain);

  function showNone({ no_route }: RobotAnswer, maze: MazeData) {
    stage.show(maze, null, null, `${maze.name}, without a route`);
    caption.replaceChildren(h('strong', maze.name), ' without a route');
    times.replaceChildren(h('p.note', no_route && `${maze.name} ${no_route}`));
  }
  function showRoute(called: string, route: RobotRoute, was: RobotRoute | null, maze: MazeData) {
    const { name } = draft.origin;
    const other = was && was.route !== route.route ? was.path : null;
    const faster = was && was.time_us !== route.time_us ? `, ${name} ${seconds(was)}` : '';
    caption.replaceChildren(
      h('strong', `${called} in ${maze.name}: ${seconds(route)}`),
      ` from rest to the centre of the goal${faster}`,
    );
    stage.show(maze, route.path, other, `The best route of ${maze.name}: ${seconds(route)}`);
    const compared = other
      ? `Another way than that of ${name}, which is the broken line.`
      : was && `The same way as that of ${name}.`;
    times.replaceChildren(
      routeTable(route, was),
      h('p.note', compared),
      h('details', h('summary', 'Piece by piece'), h('p.notation', route.route)),
    );
  }
  return {
    room: h('figure.robot-room', h('figcaption', caption, looks), stage.stage.element),
    times,
    saving: h(
      'div.row',
      button('Save route (PNG)', () => save('png')),
      button('Save route (SVG)', () => save('svg')),
    ),
    /** `was` is the route of the robot that it began from. */
    show(called: string, answer: RobotAnswer, was: RobotRoute | null, maze: MazeData) {
      if (answer.route) showRoute(called, answer.route, was, maze);
      else showNone(answer, maze);
    },
  };
}
