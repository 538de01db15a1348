// The tables and pictures of a race.
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { RaceGroup } from '../core/types';
import type { EarlyPage } from '../page/page';
import { boardOf, groupsOf, type Board } from '../results/contests';
import type { LoadedRace } from '../results/loaded';
import { replayContests } from './contest-play';
import { Distributions } from './curves';
import { Duel } from './duel';
import { Heat } from './heat';
import { Leaderboard } from './leaderboard';
import { Matrix } from './matrix';
import { errorCurves } from './error-curves';
import { ErrorCurvesPicture } from './error-curves-picture';
import { facts, Part } from './parts';
import { Button } from '../ui/controls';

interface BoardProps {
  page: EarlyPage;
  race: LoadedRace;
  board: Board;
}

/** Where steps are lost: in seconds that depends on speed and heading, too, and is no matter of cells. */
const LossPart = (props: BoardProps) => {
  const { title, inSteps } = props.board.shows;
  const elsewhere =
    'This map is drawn of races in steps. Elsewhere a move costs what its speed and heading make of it, so that no cell alone can be blamed: choose a contest above, and compare two mice on one clock.';
  if (!inSteps) return <Part title={`Where steps are lost${title}`} about={elsewhere} />;
  const about =
    'What the contests of a maze cost beyond the best possible score, by the cell in which it was lost. A step loses what it leaves the mouse behind a shortest way; after the goal, every step of the search run counts.';
  return (
    <Part title="Where steps are lost" about={about}>
      <Heat {...props} />
    </Part>
  );
};

/** The pictures of one world; `order` has the positions of its mice. */
function BoardParts({ order, search, ...props }: BoardProps & { order: number[]; search: string }) {
  const { page, race, board } = props;
  const { title, bestMeaning } = board.shows;
  const replay = replayContests(page, race, board);
  const both = (a: number, b: number, maze: number) => replay([a, b].map((mouse) => ({ mouse, maze, position: 0 })));
  const closeness = 'How close each mouse came to the best possible score. Choose a cell to open its replay.';
  const within = `How many contests of a mouse score within a given ratio of the ${bestMeaning}. Further up and to the left is better.`;
  return (
    <>
      <Part title={`Mice × mazes${title}`} about={closeness}>
        <Matrix {...{ board, order, search }} open={(mouse, maze, position) => replay([{ mouse, maze, position }])} />
      </Part>
      <Part title={`Distributions${title}`} about={within}>
        <Distributions board={board} />
      </Part>
      {board.mice.length > 1 && (
        <Part title={`Two mice${title}`}>
          <Duel page={page} board={board} open={both} />
        </Part>
      )}
      <LossPart {...props} />
    </>
  );
}

/** Once the next frame has been painted; at once where nothing is painted. */
function afterFrame(act: () => void) {
  if (document.hidden) setTimeout(act);
  else requestAnimationFrame(() => setTimeout(act));
}

/**
 * The boards of a race after the next frame, for their pictures take longer than its tables, and need the contests sorted;
 * then `drawn` hears of the first.
 */
function useBoards(groups: RaceGroup[], drawn: (first: Board) => void): Board[] {
  const [boards, set] = useState<Board[]>([]);
  useEffect(() => {
    let wanted = true;
    afterFrame(() => wanted && set(groups.map((group) => boardOf(group, groups))));
    return () => void (wanted = false);
  }, [groups]);
  useEffect(() => void (boards.length > 0 && drawn(boards[0])), [boards]);
  return boards;
}

/** What is known of a race that is shown. */
export function useRace(race: LoadedRace, drawn: (first: Board) => void) {
  const groups = useMemo(() => groupsOf(race.results), [race]);
  const boards = useBoards(groups, drawn);
  const [search, setSearch] = useState('');
  /** The positions of the mice of each group. */
  const [orders, setOrders] = useState<number[][]>([]);
  const setOrder = (group: number) => (order: number[]) =>
    setOrders((before) => groups.map((_, i) => (i === group ? order : (before[i] ?? []))));
  return { race, groups, boards, search, setSearch, orders, setOrder };
}

type Raced = ReturnType<typeof useRace>;

interface TablesProps {
  page: EarlyPage;
  raced: Raced;
  isExample: boolean;
}

export function Tables({ page, raced: { race, groups, search, setSearch, setOrder }, isExample }: TablesProps) {
  const { results } = race;
  const goBack = page.backToReport();
  const save = () => page.save('results.json', `${JSON.stringify(results)}\n`, 'application/json');
  return (
    <>
      <p class="note facts">
        {isExample && 'An example: '}
        {facts(results)}
      </p>
      <Part title="Leaderboard">
        <div class="row controls">
          <input
            type="search"
            placeholder="Search mice"
            aria-label="Search mice by name"
            value={search}
            onInput={({ currentTarget }) => setSearch(currentTarget.value)}
          />
          <Button label="Save results" act={save} />
          {goBack && <Button label="Back to the report" act={goBack} />}
        </div>
        {groups.map((group, i) => (
          <Leaderboard group={group} among={groups} search={search} onOrder={setOrder(i)} />
        ))}
      </Part>
    </>
  );
}

export function Pictures({ page, raced: { race, groups, boards, search, orders } }: Omit<TablesProps, 'isExample'>) {
  const curves = useMemo(() => errorCurves(groups), [groups]);
  const finished = 'The share of contests that each mouse finished.';
  return (
    <div class="race pictures">
      {boards.length > 0 && curves && (
        <Part title={`As ${curves.scaled} grows`} about={finished}>
          <ErrorCurvesPicture curves={curves} />
        </Part>
      )}
      {boards.map((board, i) => (
        <BoardParts {...{ page, race, board, search }} order={orders[i] ?? []} />
      ))}
    </div>
  );
}
