// The map of a real robot, with the robot, its route, and walls that it saw wrongly.
import type { LiveFinding, LiveState } from '../core/types';
import { closedWalls, halfX, halfY, wallIndex, type Geometry } from '../maze/geometry';
import * as maze from '../maze/painter';
import type { Palette } from '../maze/palette';
import { createStage, StageRoom } from '../maze/stage';

const quarterTurns = { north: 0, east: 1, south: 2, west: 3 };

/** The unseen inner walls, in lists over walls. */
export function unseenWalls({ unseen, maze: { width, height } }: LiveState): number[] {
  const cells = width * height;
  return unseen.flatMap((sides, i) => [...(sides & 1 ? [i] : []), ...(sides & 2 ? [cells + i] : [])]);
}

function paintRoute(context: maze.Context, g: Geometry, palette: Palette, route: LiveState['route']) {
  context.strokeStyle = palette.route;
  context.lineWidth = Math.max(1.5 * g.ratio, g.pitch * 0.08);
  context.lineJoin = context.lineCap = 'round';
  context.beginPath();
  for (const [x, y] of route) context.lineTo(halfX(g, 2 * x + 1), halfY(g, 2 * y + 1));
  context.stroke();
}

function paintRobot(
  context: maze.Context,
  g: Geometry,
  palette: Palette,
  { cell, heading }: NonNullable<LiveState['pose']>,
) {
  context.save();
  context.translate(halfX(g, 2 * cell[0] + 1), halfY(g, 2 * cell[1] + 1));
  context.rotate((quarterTurns[heading] * Math.PI) / 2);
  context.fillStyle = palette['to-goal'];
  context.beginPath();
  context.moveTo(0, -0.32 * g.pitch);
  context.lineTo(0.24 * g.pitch, 0.28 * g.pitch);
  context.lineTo(0, 0.14 * g.pitch);
  context.lineTo(-0.24 * g.pitch, 0.28 * g.pitch);
  context.fill();
  context.restore();
}

function paintWall(context: maze.Context, g: Geometry, { cell, side }: LiveFinding, thickness: number) {
  const index = cell && side ? wallIndex(g, cell, side) : -1;
  if (index >= 0) maze.fillWall(context, g, index, thickness);
}

/** False walls are thick; missed walls are thin in the same tone, for there is no wall in the map. */
export function paintLive(context: maze.Context, g: Geometry, palette: Palette, live: LiveState) {
  maze.paintGround(context, g, palette);
  maze.paintPlates(context, g, palette, live.maze);
  maze.paintLetters(context, g, palette, live.maze, true);
  context.fillStyle = palette.line;
  for (const wall of unseenWalls(live)) maze.fillWall(context, g, wall);
  maze.paintPosts(context, g, palette);
  maze.paintWalls(context, g, palette, closedWalls(live.maze));
  context.fillStyle = palette.candidate;
  for (const wall of live.contradictions) paintWall(context, g, wall, g.wall);
  context.fillStyle = palette.wrong;
  for (const wall of live.wrong) paintWall(context, g, wall, wall.kind === 'false_wall' ? 2 * g.wall : g.wall);
  if (live.route.length > 0) paintRoute(context, g, palette, live.route);
  if (live.pose) paintRobot(context, g, palette, live.pose);
  if (g.left > g.wall) maze.paintNumbers(context, g, palette);
}

export function mapInWords({ pose, lines, wrong, contradictions }: LiveState): string {
  const place = pose ? `robot at (${pose.cell.join(',')}) ${pose.heading}` : 'place of the robot unknown';
  return `Map after ${lines} lines: ${place}; ${contradictions.length} contradictions, ${wrong.length} wrong walls.`;
}

/** A stage that shows `live()`; `update` after it has changed. */
export function createRobotMap(live: () => LiveState | null) {
  const stage = createStage(
    { width: 16, height: 16 },
    (context, g, palette) => {
      const now = live();
      if (now) paintLive(context, g, palette, now);
    },
    { numbers: true },
  );
  let size = '';
  return {
    stage,
    update() {
      const now = live();
      if (!now) return;
      const { width, height } = now.maze;
      if (size !== (size = `${width}x${height}`)) stage.resize({ width, height });
      stage.describe(mapInWords(now));
      stage.redraw();
    },
  };
}

export const MapRoom = ({ map }: { map: ReturnType<typeof createRobotMap> }) => <StageRoom stage={map.stage} />;
