// The best route of the maze: on a stage, and its times, beside those of the robot that it began from.
import type { MazeData, RobotRoute } from '../core/types';
import { savePicture } from '../maze/saved';
import { StageRoom } from '../maze/stage';
import type { Page } from '../page/page';
import { StageLooks } from '../player/looks';
import { RouteTable } from './figures';
import { createRouteStage } from './route-stage';
import { Button } from '../ui/controls';

export type RoutePanel = ReturnType<typeof createRoutePanel>;

/** What is shown. */
interface Shown {
  /** The robot, and the one that it began from. */
  called: string;
  origin: string;
  maze: MazeData;
  /** Null where there is none; `reason` says why. */
  route: RobotRoute | null;
  reason: string;
  /** The route of the robot that it began from. */
  was: RobotRoute | null;
}

const seconds = ({ time_us }: RobotRoute) => `${(time_us / 1e6).toFixed(3)} s`;

/** The way of the robot that it began from, where that is another one. */
const otherWay = ({ route, was }: Shown) => (was && was.route !== route?.route ? was.path : null);

export function createRoutePanel() {
  const stage = createRouteStage();
  const state = { shown: null as Shown | null };
  return {
    stage,
    state,
    show(shown: Shown) {
      const { maze, route } = shown;
      const words = route ? `The best route of ${maze.name}: ${seconds(route)}` : `${maze.name}, without a route`;
      state.shown = shown;
      stage.show(maze, route?.path ?? null, route && otherWay(shown), words);
    },
  };
}

function Caption({ shown: { called, origin, maze, route, was } }: { shown: Shown }) {
  if (!route)
    return (
      <>
        <strong>{maze.name}</strong> without a route
      </>
    );
  const other = was && was.time_us !== route.time_us && `, ${origin} ${seconds(was)}`;
  return (
    <>
      <strong>
        {called} in {maze.name}: {seconds(route)}
      </strong>{' '}
      from rest to the centre of the goal{other}
    </>
  );
}

export const RouteRoom = ({ panel: { stage, state } }: { panel: RoutePanel }) => (
  <figure class="robot-room">
    <figcaption>
      <span class="robot-line">{state.shown && <Caption shown={state.shown} />}</span>
      <StageLooks stage={stage.stage} />
    </figcaption>
    <StageRoom stage={stage.stage} />
  </figure>
);

function Times({ shown }: { shown: Shown }) {
  const { maze, route, was, origin, reason } = shown;
  if (!route)
    return (
      <p class="note">
        {reason && `${maze.name} `}
        {reason}
      </p>
    );
  const same = was && `The same way as that of ${origin}.`;
  return (
    <>
      <RouteTable route={route} before={was} />
      <p class="note">{otherWay(shown) ? `Another way than that of ${origin}, which is the broken line.` : same}</p>
      <details>
        <summary>Piece by piece</summary>
        <p class="notation">{route.route}</p>
      </details>
    </>
  );
}

/** Its times, and the picture as a file, called as `robot` says. */
export function RouteTimes({ panel: { stage, state }, page, robot }: { panel: RoutePanel; page: Page; robot: string }) {
  const { shown } = state;
  const save = (ending: 'png' | 'svg') =>
    savePicture(page.save, `${robot}-${shown?.maze.name || 'route'}`, ending, stage.picture()).catch(page.complain);
  return (
    <>
      <div>
        <h3>The best route</h3>
        <div>{shown && <Times shown={shown} />}</div>
      </div>
      <div class="row">
        <Button label="Save route (PNG)" act={() => save('png')} />
        <Button label="Save route (SVG)" act={() => save('svg')} />
      </div>
    </>
  );
}
