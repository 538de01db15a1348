// What the page knows of each world in which mice race: where its figures stand in results, in which unit they are, and
// how a contest is run again. A world that is not listed is shown by the fields that all have.
import type { Core } from '../core/client';
import type { Fields, MazeData, Play, RaceGroup } from '../core/types';
import { isNumber, orNull } from '../ui/format';

/** A column of a leaderboard: a figure of a mouse. */
export interface FigureColumn {
  title: string;
  meaning: string;
  value: (mouse: Fields) => unknown;
  digits: number;
  /** What stands in the cell, where that is not the value with its digits. */
  text?: (mouse: Fields) => string;
  best?: 'ascending' | 'descending';
}

/** What stands in the result of one contest. */
export interface Figures {
  score: number | null;
  /** Where it is not the score that says so. */
  solved?: boolean;
  exploration?: number | null;
  speed?: number | null;
  /** In place of the outcome. */
  outcome?: string;
  /** What the mouse wrote last. */
  words?: string;
}

export interface RacedWorld {
  /** Behind the titles of its pictures; empty for the world at the top of results. */
  title: string;
  /** What a contest without a score counts where mice are compared; null in results of older versions that do not say it. */
  limit: number | null;
  /** Whether contests without a score count in the mean; where they do not, mice that scored in more come first. */
  countsFailures: boolean;
  /** Whether a speed run is compared with the shortest one. */
  comparesRuns?: boolean;
  /** Whether the core can say in which cells its contests lose their score. */
  losesCells?: boolean;
  /** Of scores and their differences. */
  unit: string;
  /** What the best possible score is called, and what it is. */
  best: string;
  bestMeaning: string;
  /** The key of the mean score over all contests, and what it counts. */
  mean: string;
  meanMeaning: string;
  /** The key of how many contests were scored. */
  solved: string;
  bound: (maze: Fields) => number | null;
  optimum: (maze: Fields) => number | null;
  contest: (result: Fields) => Figures;
  columns: FigureColumn[];
  /** Runs a contest again under the conditions of the race; null where the page cannot. */
  again?: (
    core: Core,
    conditions: Fields,
    contest: { mouse: string; maze: MazeData; seed: number },
  ) => Promise<{ play: Play; record: string }>;
}

const seconds = (microseconds: unknown) => (isNumber(microseconds) ? microseconds / 1e6 : null);
const percent = (share: unknown) => isNumber(share) && 100 * share;
const inner = (value: unknown, key: string): unknown =>
  typeof value === 'object' && value !== null ? (value as Fields)[key] : undefined;

/** A column that is a field of the mouse. */
const column = (title: string, key: string, digits: number, meaning: string, best?: FigureColumn['best']) => ({
  title,
  meaning,
  value: (mouse: Fields) => mouse[key],
  digits,
  best,
});

const ratioColumn = (best: string): FigureColumn => ({
  title: `score / ${best}`,
  meaning: 'Mean over the solved contests of the score divided by the best possible one in that maze.',
  value: (mouse) => mouse.mean_ratio,
  digits: 3,
});

const steps: Known = {
  countsFailures: true,
  comparesRuns: true,
  losesCells: true,
  unit: 'steps',
  best: 'best',
  bestMeaning: 'best possible score, that of a mouse that knows the maze',
  mean: 'penalised_mean',
  meanMeaning:
    'Mean score over all contests, in steps: speed run plus a thirtieth of the exploration; a failed one counts 100.',
  solved: 'solved',
  bound: ({ bound }) => orNull(bound),
  optimum: ({ optimum }) => orNull(optimum),
  contest: (result) => ({
    score: orNull(result.score),
    exploration: orNull(result.exploration_steps),
    speed: orNull(result.speed_steps),
    words: String(result.last_words ?? ''),
  }),
  columns: [
    column('score, solved', 'mean_score', 3, 'Mean score over the solved contests, in steps.'),
    ratioColumn('best'),
    column(
      'explor. steps',
      'mean_exploration_steps',
      1,
      'Mean exploration steps of the solved contests, including the reset.',
    ),
    column(
      'steps too many',
      'mean_speed_over_optimum',
      2,
      'Mean steps by which the speed runs of the solved contests were longer than the shortest run of their maze.',
    ),
    {
      title: 'best runs, %',
      meaning: 'Percentage of all contests whose speed run was a shortest one.',
      value: (mouse) => percent(mouse.optimal_share),
      digits: 1,
      best: 'descending',
    },
    column(
      'µs a step',
      'microseconds_per_decision',
      2,
      'Mean time per decision, in microseconds: the only figure that changes from race to race.',
    ),
  ],
  again: (core, { budget }, contest) => core.call('run', { ...contest, ...(isNumber(budget) && { budget }) }),
};

const inSeconds: Known = {
  countsFailures: false,
  unit: 's',
  best: 'best',
  bestMeaning: 'best possible score, that of the fastest route, driven at once',
  mean: 'mean_score',
  meanMeaning: 'Mean score in seconds, over the contests that have one.',
  solved: 'scored',
  bound: ({ bound_us }) => seconds(bound_us),
  optimum: ({ fastest_us }) => seconds(fastest_us),
  contest: (result) => ({ score: seconds(inner(result.score, 'value')) }),
  columns: [
    ratioColumn('best'),
    column('search, s', 'mean_search', 1, 'Mean time of the contests until the first fast run began, in seconds.'),
    column('best run, s', 'mean_best', 3, 'Mean time of the best runs from rest at the start to the goal, in seconds.'),
    {
      title: 'above fastest, %',
      meaning: 'How much longer the routes of the best runs take than the fastest route, in percent.',
      value: (mouse) => percent(mouse.mean_excess),
      digits: 2,
    },
    column('best runs', 'optimal', 0, 'Contests whose best run took the fastest route.', 'descending'),
    column('proven', 'proven', 0, 'Contests in which the mouse knew that no route could be faster.', 'descending'),
    column('runs', 'mean_starts', 1, 'Mean number of starts in a contest.'),
  ],
  again: (core, { robot, rules }, contest) =>
    core.call('drive', {
      ...contest,
      robot: robot as Fields,
      rules: String(inner(rules, 'name') ?? ''),
    }),
};

const count = (title: string, key: string, meaning: string) => column(title, key, 0, meaning);

/** The ends of an interval of shares, as whole per cent. */
function shares(interval: unknown): string {
  if (!Array.isArray(interval) || !interval.every(isNumber)) return '–';
  return interval.map((end) => (100 * end).toFixed(0)).join('–');
}

/** What results say of a race besides its mice and mazes. */
const conditionsOf = ({ mice: _mice, mazes: _mazes, ...conditions }: Fields): Fields => conditions;

const physical: Known = {
  ...inSeconds,
  bestMeaning: 'best possible score, that of a mouse that never errs and knows the maze',
  columns: [
    {
      title: 'scored, 95 %',
      meaning: 'Share of the contests that ended with a score, in per cent: 95 % interval over the mazes.',
      value: ({ finished_interval: ends }) => Array.isArray(ends) && ends[0],
      digits: 2,
      text: ({ finished_interval }) => shares(finished_interval),
      best: 'descending',
    },
    column(
      'penalised, s',
      'penalised',
      3,
      'Mean score over all contests, in seconds; one without a score counts the time limit.',
    ),
    ...inSeconds.columns.slice(0, 3),
    count('runs', 'starts', 'Runs that began at the start, searches among them.'),
    count('slid', 'slid', 'Runs that ended in a crash because the tyres did not hold.'),
    count('strayed', 'strayed', 'Runs that ended in a crash because the mouse was not where it believed to be.'),
    count('misread', 'misread', 'Runs that ended in a crash into a wall that the mouse took for open.'),
    count(
      'walled in',
      'walled_in',
      "Runs that ended because the mouse's own map had no way left, or did not fit what it saw.",
    ),
    count('late', 'late', 'Runs that the end of the time cut short.'),
    count('misread walls', 'misreads', 'Walls that it took for what they are not.'),
  ],
  again: (core, conditions, contest) =>
    core.call('contest', { ...contest, world: String(conditions.world), conditions: conditionsOf(conditions) }),
};

const mms: Known = {
  countsFailures: true,
  unit: 'points',
  best: 'best',
  bestMeaning: 'best possible score',
  mean: 'mean_score',
  meanMeaning: 'Mean score of mms over all runs; an unsolved one counts 2000, as in mms.',
  solved: 'solved',
  bound: ({ best_score }) => orNull(best_score),
  optimum: ({ best_run }) => orNull(best_run),
  contest: (result) => ({
    score: orNull(result.score),
    solved: result.solved === true,
    outcome: String(result.end || result.outcome),
    words: Array.isArray(result.errors) ? result.errors.join('\n') : '',
  }),
  columns: [
    ratioColumn('best'),
    column('best run', 'mean_best_run', 1, 'Mean of the best runs from start to goal, in steps of mms.'),
  ],
};

/** Words and figures that a page has beyond those that results bring. */
type Known = Omit<RacedWorld, 'title' | 'limit'>;

/** The score where the world says that it stands. */
function placedScore(result: Fields, place: unknown): number | null {
  const {
    key = 'score',
    inner: field = '',
    unit = 1,
  } = (place ?? {}) as { key?: string; inner?: string; unit?: number };
  const value = field === '' ? result[key] : inner(result[key], field);
  return isNumber(value) ? value * unit : null;
}

const texts = (list: unknown): string[] => (Array.isArray(list) ? list.map(String) : []);

/** Of any other world: what its results say of it. */
const described = ({ unit, score, columns, mice, failure_score }: RaceGroup): Known => ({
  countsFailures: isNumber(failure_score),
  unit: typeof unit === 'string' ? unit : 'points',
  best: 'best',
  bestMeaning: 'best possible score',
  mean: 'mean_score',
  meanMeaning: isNumber(failure_score)
    ? 'Mean score over all contests.'
    : 'Mean score over the contests that have one.',
  solved: mice.some((mouse) => 'scored' in mouse) ? 'scored' : 'solved',
  bound: ({ bound, bound_us }) => orNull(bound) ?? seconds(bound_us),
  optimum: () => null,
  contest: (result) => ({ score: placedScore(result, score) }),
  columns: [
    ratioColumn('best'),
    ...texts(columns).map((title, i) => ({
      title,
      meaning: 'A figure of this world.',
      value: (mouse: Fields) => Number.parseFloat(texts(mouse.cells)[i]),
      digits: 2,
      text: (mouse: Fields) => texts(mouse.cells)[i] ?? '–',
    })),
  ],
});

const known = new Map(Object.entries({ steps, seconds: inSeconds, physical, fallible: physical, mms }));

/** What the page shows of the world of a race. */
export function worldOf(group: RaceGroup): RacedWorld {
  const noise = isNumber(group.noise) ? `, noise ${group.noise}` : '';
  const title = isHome(group) ? '' : `, ${group.world}${noise}`;
  return {
    ...(known.get(group.world) ?? described(group)),
    title,
    limit: orNull(group.limit_score) ?? orNull(group.failure_score),
  };
}

/** The world whose race stands at the top of results. */
const home = 'steps';
/** What a world that the core offers is called here: results know the home world under that name. */
export const calledOf = (world: { name: string; home: boolean }): string => (world.home ? home : world.name);
export const isHome = ({ world }: { world: string }): boolean => world === home;

/** The race at the top of results, as the groups are. */
export const homeGroup = (fields: Fields): RaceGroup => ({ ...fields, world: home }) as RaceGroup;
