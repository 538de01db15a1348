// A cell of the matrix in words.
import { isNumber, number, scoreText } from '../ui/format';
import type { Board, Cell, Contest } from '../results/contests';
import { meanOf } from '../results/contests';

/** One contest: "finished, score 39.100 = search 117, speed 35 (1 beyond the shortest)". */
export function contestText(contest: Contest, optimum: number | null): string {
  if (!contest.finished) return contest.outcome;
  const parts = [`finished, score ${scoreText(contest.score)}`];
  if (contest.search !== null) parts.push(`search ${contest.search} steps`);
  if (contest.speed !== null) {
    const beyond = isNumber(optimum) ? contest.speed - optimum : null;
    parts.push(
      `speed run ${contest.speed} steps${beyond === null ? '' : beyond === 0 ? ' (a shortest one)' : ` (${beyond} beyond the shortest)`}`,
    );
  }
  return parts.join(', ');
}

function several(cell: Cell): string {
  const scores = cell.contests.flatMap(({ score, finished }) => (finished && score !== null ? [score] : []));
  const mean = meanOf(scores);
  return `finished ${cell.finished} of ${cell.contests.length}${mean === null ? '' : `, mean score of these ${number(mean, 3)}`}`;
}

/** All of a cell: "ariadne in 13ye (16×16): …; bound 35.167, score / bound 1.112". */
export function cellText(board: Board, mouse: number, maze: number): string {
  const { short, width, height, bound, optimum } = board.mazes[maze];
  const cell = board.cells[mouse][maze];
  const where = `${board.mice[mouse].shown} in ${short} (${width}×${height})`;
  if (bound === null) return `${where}: the goal cannot be reached`;
  if (cell.contests.length === 0) return `${where}: no contest`;
  const what = cell.contests.length === 1 ? contestText(cell.contests[0], optimum) : several(cell);
  const ratio = cell.ratio === null ? '' : `, score / best ${number(cell.ratio, 3)}`;
  return `${where}: ${what}; best ${scoreText(bound)}${ratio}`;
}
