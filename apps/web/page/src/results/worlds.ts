// How races are shown, in any world: as the tables of the core say (core/worlds.json), or for a world that is not among
// them, as its results do.
import type { Core } from '../core/client';
import type { Fields, MazeData, Play, RaceGroup, ShownColumn, ShownWorld, ShownWorlds } from '../core/types';
import tables from '../core/worlds.json';
import { isNumber, number, orNull } from '../ui/format';
import type { Column } from '../ui/sorted-table';

export interface RacedWorld {
  /** Behind the titles of its pictures; empty for races in steps. */
  title: string;
  /** Whether the core knows where its contests lose their steps. */
  inSteps: boolean;
  /** What a contest without a score counts where mice are compared; null in results of older versions that do not say it. */
  limit: number | null;
  /** Whether contests without a score count in the mean; where they do not, mice that scored in more come first. */
  countsFailures: boolean;
  /** Of scores and their differences. */
  unit: string;
  /** What the best possible score is. */
  bestMeaning: string;
  /** The column of the mean score over all contests, and its key. */
  mean: Column<Fields> & { key: string };
  /** The other columns of the leaderboard. */
  columns: Column<Fields>[];
  bound: (maze: Fields) => number | null;
  score: (result: Fields) => number | null;
  /** Runs a contest again under the conditions of the race; missing where the page cannot. */
  again?: (
    core: Core,
    contest: { mouse: string; maze: MazeData; seed: number },
  ) => Promise<{ play: Play; record: string }>;
}

const inner = (value: unknown, key: string): unknown =>
  typeof value === 'object' && value !== null ? (value as Fields)[key] : undefined;
const scaled = (value: unknown, factor: number) => (isNumber(value) ? factor * value : null);

/** A column that shows a field of the mouse: a number, or an interval, which is sorted by its lower end. */
function columnOf({ key, title, meaning, digits, factor = 1, higher_is_better }: ShownColumn): RacedWorld['mean'] {
  const values = (mouse: Fields) => [mouse[key]].flat().map((value) => scaled(value, factor));
  return {
    key,
    title,
    meaning,
    value: (mouse) => values(mouse)[0] ?? null,
    show: (mouse) =>
      values(mouse)
        .map((value) => number(value, digits))
        .join('–'),
    best: higher_is_better ? 'descending' : 'ascending',
  };
}

const text = (value: unknown) => (typeof value === 'string' ? value : undefined);
const texts = (list: unknown): string[] => (Array.isArray(list) ? list.map(String) : []);
/** Those that results name, of a world that is not in the tables: their texts stand in the line of each mouse. */
const namedColumns = ({ columns }: RaceGroup): Column<Fields>[] =>
  texts(columns).map((title, i) => ({
    title,
    meaning: 'A figure of this world.',
    value: ({ cells }) => orNull(Number.parseFloat(texts(cells)[i])),
    show: ({ cells }) => texts(cells)[i] ?? '–',
    best: 'ascending',
  }));

const isMean = ({ key }: ShownColumn) => key === 'mean_par1' || key === 'mean_score';
const usualMean: ShownColumn = {
  key: 'mean_score',
  title: 'score',
  meaning: 'Mean score over the contests that have one, or over all where the others count.',
  digits: 3,
};

const ratio = columnOf({
  key: 'mean_ratio',
  title: 'score / best',
  meaning: 'Mean over the finished contests of the score divided by the best possible one in that maze.',
  digits: 3,
});

/** What `contest` is asked besides mouse, maze and seed. */
const conditionsOf = ({ mice: _mice, mazes: _mazes, world, ...conditions }: RaceGroup) => ({ world, conditions });

/** The name of the robot of a race; empty in a world without robots. */
function robotOf({ robot }: RaceGroup): string {
  const { name } = (robot ?? {}) as { name?: unknown };
  return typeof name === 'string' ? name : '';
}

/** What the page shows of the world of a race; titles name the robot where the races `among` it have several. */
export function worldOf(group: RaceGroup, among: RaceGroup[] = []): RacedWorld {
  const table = (tables as ShownWorlds).find(({ names }) => names.includes(group.world))?.table;
  const said = table ?? (group as Partial<ShownWorld>);
  const { failure_score } = said;
  // Files of earlier versions do not have its place.
  const bound: Partial<ShownWorld['bound']> = said.bound ?? {};
  // The rules of a race can have a unit of their own.
  const unit = text(group.unit) ?? said.unit ?? 'points';
  const {
    key = 'score',
    inner: field = '',
    unit: factor = 1,
  } = (said.score ?? {}) as Partial<NonNullable<ShownWorld['score']>>;
  const robots = new Set(among.filter(({ world }) => world === group.world).map(robotOf));
  const robot = robots.size > 1 ? `, ${robotOf(group)}` : '';
  const errors = (['noise', 'variation'] as const)
    .map((scaled) => [scaled, group[scaled]] as const)
    .filter(([, scale]) => isNumber(scale))
    .map(([scaled, scale]) => `, ${scaled} ${String(scale)}`)
    .join('');
  const mean = table?.columns.find(isMean) ?? usualMean;
  const own = table?.columns.filter((column) => column !== mean).map(columnOf);
  return {
    title: table?.in_steps ? '' : `, ${group.world}${robot}${errors}`,
    inSteps: table?.in_steps ?? false,
    limit: orNull(group.limit_score) ?? orNull(group.failure_score) ?? orNull(failure_score),
    countsFailures: isNumber(failure_score),
    unit,
    bestMeaning: table?.bound_meaning ?? 'best possible score',
    mean: columnOf(mean),
    columns: [ratio, ...(own ?? namedColumns(group))],
    bound: (maze) => scaled(maze[bound.key ?? 'bound'], bound.unit ?? 1) ?? scaled(maze.bound_us, 1e-6),
    score: (result) => scaled(field === '' ? result[key] : inner(result[key], field), factor),
    again: table?.plays ? (core, contest) => core.call('contest', { ...contest, ...conditionsOf(group) }) : undefined,
  };
}
