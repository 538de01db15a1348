// The order of mazes in pictures.
import type { Board, BoardMaze } from '../results/contests';
import { meanOf } from '../results/contests';
import { sorted } from '../ui/sorting';

export const mazeOrders = ['name', 'best possible', 'how hard'] as const;
export type MazeOrder = (typeof mazeOrders)[number];

/** How hard mazes were: first by the share of contests that failed, then by the mean of score / bound; null without a contest. */
export function hardness({ cells, mice }: Board, maze: number): number | null {
  const column = mice.filter(({ reference }) => !reference).map(({ index }) => cells[index][maze]);
  const shares = column
    .filter(({ contests }) => contests.length > 0)
    .map(({ contests, finished }) => 1 - finished / contests.length);
  const ratio = meanOf(column.flatMap((cell) => (cell.ratio === null ? [] : [cell.ratio])));
  const failed = meanOf(shares);
  // A ratio counts less than any difference in the shares that a race can have.
  return failed === null ? null : failed + Math.min(ratio ?? 0, 1e4) * 1e-9;
}

/** The positions of the mazes; the easiest, and the lowest best possible score, first. */
export function orderedMazes(board: Board, order: MazeOrder): number[] {
  const value = {
    name: (maze: BoardMaze) => maze.short,
    'best possible': (maze: BoardMaze) => maze.bound,
    'how hard': (maze: BoardMaze) => (maze.bound === null ? null : hardness(board, maze.index)),
  }[order];
  return sorted(board.mazes, value, 'ascending').map(({ index }) => index);
}
