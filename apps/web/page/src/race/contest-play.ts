// The replay of one contest of a race: from its record, or run again with the same seed.
import type { MazeData, PackedRecord, Play } from '../core/types';
import type { EarlyPage } from '../page/page';
import type { LoadedRace } from '../results/loaded';
import type { Board, Contest } from '../results/contests';
import { isNumber, scoreText } from '../ui/format';

export interface ContestPlay {
  play: Play;
  record: string;
  /** What should be known of this replay; empty where nothing. */
  remark: string;
}

type Found = Omit<ContestPlay, 'remark'>;

/** The record of that contest: the one of its seed, or the one in its place where there are no seeds. */
export function recordOf(records: PackedRecord[], contest: Contest, position: number): PackedRecord | null {
  const same = records.find(({ seed }) => seed !== undefined && seed === contest.seed);
  if (same) return same;
  const other = records[position];
  return other && (other.seed === undefined || contest.seed === null) ? other : null;
}

const sameActions = (a: Play, b: Play) =>
  a.action.length === b.action.length && a.action.every((action, i) => action === b.action[i]);

/** Whether the page can run it: `flood:stride=1` and `oracle` are built in, `program:...` is not. */
export async function isOurs(page: EarlyPage, mouse: string) {
  const { mice } = await page.ready;
  const name = mouse.split(':', 1)[0];
  return name === 'oracle' || mice.some((one) => one.name === name);
}

async function runAgain(
  page: EarlyPage,
  board: Board,
  mouse: string,
  maze: MazeData,
  contest: Contest,
): Promise<Found | null> {
  const { again } = board.shows;
  if (!again || contest.seed === null || !(await isOurs(page, mouse))) return null;
  return again(page.core, { mouse, maze, seed: contest.seed });
}

const differs = (mouse: string) =>
  `This version of labmouse behaves differently from the one that ran the race; this is ${mouse} as recorded.`;

/** A record that lacks reasons, and the same mouse run again, which has them: the better of the two. */
function better(recorded: Found, again: Found | null, mouse: string): ContestPlay {
  if (again && sameActions(recorded.play, again.play)) return { ...again, remark: '' };
  return { ...recorded, remark: again ? differs(mouse) : '' };
}

function scoreRemark(play: Play, contest: Contest): string {
  const same =
    play.score === contest.score ||
    (isNumber(play.score) && isNumber(contest.score) && Math.abs(play.score - contest.score) < 1e-6);
  if (same) return '';
  const before = contest.score === null ? contest.outcome : scoreText(contest.score);
  const now = play.score === null ? play.outcome : scoreText(play.score);
  return `This version of labmouse behaves differently from the one that ran the race: the results say ${before}, this run says ${now}.`;
}

/** Throws in words why there is nothing to replay. */
export async function contestPlay(
  page: EarlyPage,
  race: LoadedRace,
  board: Board,
  at: { mouse: number; maze: number; position: number },
): Promise<ContestPlay> {
  const mouse = board.mice[at.mouse].name;
  const { name, short } = board.mazes[at.maze];
  const contest = board.cells[at.mouse][at.maze].contests[at.position];
  const records = await race.records(mouse, name).catch((error) => (page.complain(error), []));
  const packed = recordOf(records, contest, at.position);
  if (!packed && !board.shows.again)
    throw new Error(
      `There is no record of ${mouse} in ${short}, and contests in the world ${board.world} are replayed from their records. Drop the record here ('labmouse race --out DIR' saves records).`,
    );
  if (!packed && !(await isOurs(page, mouse)))
    throw new Error(
      `There is no record of ${mouse} in ${short}, and the page cannot run this program. Drop its record here ('labmouse race --out DIR' saves records).`,
    );
  const maze = await race.maze(name);
  if (!maze)
    throw new Error(`The maze ${short} is not in this page. Drop its file here, then choose the contest again.`);

  const again = await runAgain(page, board, mouse, maze, contest).catch((error) =>
    packed ? null : Promise.reject(error),
  );
  if (packed) return better(await page.core.call('unpack', { record: packed, maze }), again, mouse);
  if (!again) throw new Error(`The results do not contain the seed of ${mouse} in ${short}.`);
  return { ...again, remark: scoreRemark(again.play, contest) };
}

/** Opens the replay of contests of that race, beside each other. */
export const replayContests =
  (page: EarlyPage, race: LoadedRace, board: Board) => (at: { mouse: number; maze: number; position: number }[]) => {
    page.tell('Opening the replay …');
    Promise.all(at.map((one) => contestPlay(page, race, board, one)))
      .then((plays) => {
        page.tell([...new Set(plays.map(({ remark }) => remark).filter(Boolean))].join(' '));
        page.replay(plays.map(({ play, record }) => ({ play, record })));
      })
      .catch((error) => {
        page.tell('');
        page.complain(error);
      });
  };
