// What a drawing is: a maze, and every way to change it. Each gives a new maze; none touches the one that it was given.
import type { Cell, HeadingName, MazeData } from '../core/types';

/** A wall that can be drawn: the north or the east side of that cell, not on the border. */
export interface Wall {
  x: number;
  y: number;
  side: 'north' | 'east';
}

export const headings: readonly HeadingName[] = ['north', 'east', 'south', 'west'];

/** One cell on in each direction, and the bit of that side in `walls`. */
const towards: Record<HeadingName, { x: number; y: number; bit: number; opposite: number }> = {
  north: { x: 0, y: 1, bit: 1, opposite: 4 },
  east: { x: 1, y: 0, bit: 2, opposite: 8 },
  south: { x: 0, y: -1, bit: 4, opposite: 1 },
  west: { x: -1, y: 0, bit: 8, opposite: 2 },
};

export const isInside = (maze: MazeData, [x, y]: Cell) => x >= 0 && y >= 0 && x < maze.width && y < maze.height;

export const isSame = (one: Cell, other: Cell) => one[0] === other[0] && one[1] === other[1];

/** The cell on that side; it may lie outside. */
export const neighbour = ([x, y]: Cell, side: HeadingName): Cell => [x + towards[side].x, y + towards[side].y];

/** The wall on that side of a cell, or null where that is the border. */
export function wallOf(maze: MazeData, cell: Cell, side: HeadingName): Wall | null {
  const other = neighbour(cell, side);
  if (!isInside(maze, cell) || !isInside(maze, other)) return null;
  const [x, y] = side === 'north' || side === 'east' ? cell : other;
  return { x, y, side: side === 'north' || side === 'south' ? 'north' : 'east' };
}

export const isClosed = (maze: MazeData, { x, y, side }: Wall) =>
  (maze.walls[y * maze.width + x] & towards[side].bit) !== 0;

/** The maze with that wall closed or open, on both of its sides. */
export function withWall(maze: MazeData, wall: Wall, closed: boolean): MazeData {
  if (!wallOf(maze, [wall.x, wall.y], wall.side) || isClosed(maze, wall) === closed) return maze;
  const { x, y, bit, opposite } = towards[wall.side];
  const walls = [...maze.walls];
  walls[wall.y * maze.width + wall.x] ^= bit;
  walls[(wall.y + y) * maze.width + wall.x + x] ^= opposite;
  return { ...maze, walls };
}

/** The maze with every wall closed. */
export const withAllClosed = (maze: MazeData): MazeData => ({ ...maze, walls: maze.walls.map(() => 15) });

export const withStart = (maze: MazeData, cell: Cell): MazeData =>
  isInside(maze, cell) && !isSame(maze.start, cell) ? { ...maze, start: cell } : maze;

/** The start's heading, a quarter of a turn clockwise. */
export const withTurnedStart = (maze: MazeData): MazeData => ({
  ...maze,
  heading: headings[(headings.indexOf(maze.heading) + 1) % 4],
});

export const isGoal = (maze: MazeData, cell: Cell) => maze.goals.some((goal) => isSame(goal, cell));

const inOrder = (goals: Cell[]) => goals.sort((one, other) => one[1] - other[1] || one[0] - other[0]);

/** The maze with that cell as a goal or not. The last goal stays: a maze has one at least. */
export function withGoal(maze: MazeData, cell: Cell, on: boolean): MazeData {
  if (!isInside(maze, cell) || isGoal(maze, cell) === on || (!on && maze.goals.length === 1)) return maze;
  const goals = maze.goals.filter((goal) => !isSame(goal, cell));
  return { ...maze, goals: inOrder(on ? [...goals, cell] : goals) };
}

/** A goal carried to another cell. */
export function withMovedGoal(maze: MazeData, from: Cell, to: Cell): MazeData {
  if (!isGoal(maze, from) || !isInside(maze, to) || isSame(from, to)) return maze;
  const goals = maze.goals.filter((goal) => !isSame(goal, from) && !isSame(goal, to));
  return { ...maze, goals: inOrder([...goals, to]) };
}

/** Each cell carried to its new place in a maze of that size, each side to its new heading. */
function carried(
  maze: MazeData,
  size: [number, number],
  place: (cell: Cell) => Cell,
  turned: (side: HeadingName) => HeadingName,
): MazeData {
  const [width, height] = size;
  const walls = new Array<number>(width * height).fill(0);
  maze.walls.forEach((sides, i) => {
    const [x, y] = place([i % maze.width, Math.floor(i / maze.width)]);
    for (const side of headings) if (sides & towards[side].bit) walls[y * width + x] |= towards[turned(side)].bit;
  });
  const goals = inOrder(maze.goals.map(place));
  return { ...maze, width, height, walls, start: place(maze.start), heading: turned(maze.heading), goals };
}

/** The maze as a mirror shows it: east is west. */
export const mirrored = (maze: MazeData): MazeData =>
  carried(
    maze,
    [maze.width, maze.height],
    ([x, y]) => [maze.width - 1 - x, y],
    (side) => (side === 'east' ? 'west' : side === 'west' ? 'east' : side),
  );

/** The maze a quarter of a turn clockwise. */
export const rotated = (maze: MazeData): MazeData =>
  carried(
    maze,
    [maze.height, maze.width],
    ([x, y]) => [y, maze.width - 1 - x],
    (side) => headings[(headings.indexOf(side) + 1) % 4],
  );
