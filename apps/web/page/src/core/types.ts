// What the core (labmouse compiled to WebAssembly) is asked and answers. Cells are [x, y], (0,0) in the south-west;
// lists over cells run by y * width + x.
// Written by scripts/page-types from labmouse/lab/shapes: make changes there.

export type Cell = [number, number];

export type HeadingName = 'north' | 'east' | 'south' | 'west';

/** A maze as the core gives and takes it. */
export interface MazeData {
  name: string;
  width: number;
  height: number;
  /**
   * The closed sides of each cell: 1 north, 2 east, 4 south, 8 west. Two neighbours agree; the border is closed.
   */
  walls: number[];
  start: Cell;
  heading: HeadingName;
  goals: Cell[];
}

/**
 * What is wrong with an input. Line and column count from 1; 0 is the input as a whole, or a byte of a binary file.
 */
export interface Problem {
  line: number;
  column: number;
  reason: string;
}

/** `inspect`: what a maze is like. */
export interface Inspection {
  /**
   * Steps of the shortest speed run, and the score of a mouse that knows the maze; null where no goal can be
   * reached.
   */
  optimum: number | null;
  bound: number | null;
  /** The same under mms's rules. */
  mms_run: number | null;
  mms_score: number | null;
  shortest_cells: number | null;
  shortest_runs: number | null;
  reachable: number;
  dead_ends: number;
  junctions: number;
  loops: number;
  left_follower_arrives: boolean;
  right_follower_arrives: boolean;
  /** Each rule of the official contests, always all of them. */
  contest_rules: { name: string; passed: boolean; reason: string }[];
  /** The cells in which the steps of a shortest run end, the start first; empty where there is no way. */
  route: Cell[];
  /** Steps to the goal from each cell; -1 where there is no way. */
  distances: number[];
}

export interface Rules {
  budget: number;
  search_factor: number;
  stride: number;
}

export type ParameterType = 'whole' | 'real' | 'flag' | 'choice' | 'list' | 'prior' | 'text';

export interface Parameter {
  name: string;
  type: ParameterType;
  default: string;
  meaning: string;
  low?: number;
  high?: number;
  choices?: string[];
  /** Where it counts alone; missing where it counts everywhere. Errors: in worlds where things go wrong. */
  counts_in?: 'steps' | 'seconds' | 'errors';
  /** The defaults in classic and in half-size mazes, if they differ. */
  by_size?: string[];
  /** Whether a race may have several values, separated by commas: it is then run once for each. */
  listed?: boolean;
}

export interface Mouse {
  name: string;
  summary: string;
  is_stochastic: boolean;
  /** Whether it plays in steps. */
  walks?: boolean;
  /** Whether it drives in the worlds in seconds. */
  drives?: boolean;
  parameters: Parameter[];
  /** How it does that, in sentences. */
  method?: string;
  /** Where the idea comes from. */
  source?: string;
}

export interface Named {
  name: string;
  summary: string;
}

/** A world in which built-in mice race. The first one is meant where a race names none. */
export interface WorldInPage {
  name: string;
  summary: string;
  /** Whether the user's own mice run there, and `losses` knows where steps are lost. */
  in_steps: boolean;
  /** Whether `contest` runs a contest there with its play. */
  plays: boolean;
  /** Whether contests differ for mice, too, that are deterministic themselves. */
  is_stochastic: boolean;
  /** Contests in each maze of a stochastic mouse or world, by default. */
  usual_runs: number;
  /** What a race there is asked besides. */
  settings: Parameter[];
  mice: string[];
}

/** `about`: what the core brings. */
export interface About {
  version: string;
  compiler: string;
  mice: Mouse[];
  mazes: { name: string; width: number; height: number }[];
  formats: Named[];
  generators: Named[];
  rules: Rules & { failure_score: number };
  worlds: WorldInPage[];
  /** A contest to watch in which belief and truth part, and come together again. */
  parting: { world: string; mouse: string; maze: string; seed: number; settings: Fields };
  /** Largest side of a maze. */
  most_side: number;
  /** For contests in seconds: robots with the side of their cells in mm, and rules with their sources. */
  robots: { name: string; cell: number }[];
  /** What may stand in a robot file, in the order of its form. */
  robot_keys: RobotKey[];
  drive_rules: { name: string; source: string }[];
}

export interface Candidate {
  /** The unseen wall as [x, y, side], or null for `goal`: entering the goal. */
  wall: [number, number, 'north' | 'east'] | null;
  goal: boolean;
  seen_from: Cell;
  /** Steps of the speed run through it, and steps of the way to it. */
  through: number;
  travel: number;
  worth: boolean;
  score: number;
}

export interface Reasons {
  /** The frame before the step in which the mouse chose. */
  frame: number;
  /** In words: what it went by. */
  ground: string;
  candidates: Candidate[];
  /** Position of the chosen one; -1 for none. */
  chosen: number;
  /** Steps of the best known run; 0 for none yet. */
  known: number;
  hope: number;
  price: number;
}

/**
 * Something that a program for mms drew; it holds from that frame on. A colour is a letter of mms, one of
 * kbacgorwyBCAGORVY, a text at most two rows of five characters, the second right behind the first; '' is none.
 */
export type MmsEvent = {
  frame: number;
  kind: 'wall';
  cell: Cell;
  side: HeadingName;
  there: boolean;
} | {
  frame: number;
  kind: 'colour';
  cell: Cell;
  colour: string;
} | {
  frame: number;
  kind: 'text';
  cell: Cell;
  text: string;
} | {
  frame: number;
  kind: 'clear colours';
} | {
  frame: number;
  kind: 'clear texts';
};

/** What the world of a contest is like, for those who show it. */
export interface Traits {
  /** What it counts. Where that is steps, each is a turn and a straight move. */
  clock: 'steps' | 'seconds';
  /** Behind scores: "s"; empty where they need none. */
  unit: string;
  /** Decimals of scores. */
  digits: number;
  /** What the best possible score is. */
  bound: string;
  /** What its runs are called, by the numbers in `run`: "speed run". */
  runs: string[];
  /** Whether the map of the mouse is what its program draws, and not `known`. */
  draws: boolean;
  /** Whether `picture` draws its record. */
  pictured: boolean;
}

/**
 * One contest, frame by frame: frame 0 is before the first step, frame i after step i; the last is the end. Lists
 * `clock`, `x`, `y`, `heading`, `run` have one entry a frame, those of steps one entry a step: step i leads from
 * frame i to i + 1. In seconds a step is a move of a search, a straight or a turn, or being carried to the start.
 */
export interface Play {
  /** Its name; what it is like stands in `traits`. */
  world: string;
  traits: Traits;
  mouse: string;
  maze: MazeData;
  /** As in the record; only of a contest in steps. */
  rules: Rules | null;
  seed: number | null;
  /** In words, with the reason of a forfeit. */
  outcome: string;
  finished: boolean;
  score: number | null;
  /**
   * The best possible score and speed run here (in seconds: from rest to the centre); null where there is no way.
   */
  bound: number | null;
  optimum: number | null;
  search_steps: number;
  speed_steps: number;
  /** Shares, 0 to 1, of the cells that can be reached; null in mms. */
  discovered: number | null;
  visited: number | null;
  /** From the program, for people: show it as text. */
  last_words: string;
  counts: { name: string; value: number }[];
  /** How far a record that lacks fields was checked; empty where it gives all. */
  checked: string;
  /** False where the record breaks off. */
  ended: boolean;
  /** Steps or seconds, as `traits` says. */
  clock: number[];
  /** In half cells: the centre of cell (0,0) is (1,1). */
  x: number[];
  y: number[];
  /** Eighths of a turn clockwise from north. */
  heading: number[];
  /** The position of its name in `runs` of `traits`. */
  run: number[];
  /** What was asked for, in words: "right, 3", "ahead 2", "reset", "moveForward 2", "left V90". */
  action: string[];
  /** A wall ended the movement early (in mms and in seconds: a crash). */
  blocked: boolean[];
  /** Open cells to the left, ahead and to the right before each step; empty in mms and in seconds. */
  left: number[];
  ahead: number[];
  right: number[];
  /**
   * By wall, 2 * cells: the north side of cell i at i, its east side at cells + i. The frame from which the mouse
   * knows that wall: the reading of a step is taken in the frame before it. The border is known in frame 0; -1
   * never. In mms empty.
   */
  known: number[];
  /**
   * Only of a mouse that can detect walls wrongly: walls, as above, that it takes for what they are not, from a
   * frame on, up to another one or to the end. What it has only forgotten counts as taken for the same.
   */
  mistaken?: {
    wall: number;
    /** What it takes the wall for. */
    closed: boolean;
    from: number;
    to: number | null;
  }[];
  /**
   * The first frame in the goal, and the one in which the mouse is back at the start; null where that never came.
   */
  goal_frame: number | null;
  reset_frame: number | null;
  /** Cells entered in each step (passing through counts), as positions in lists over cells; [] where it stayed. */
  entered: number[][];
  /**
   * The cells of a best possible speed run, one a step (in mms each cell on its way), from the start; empty where
   * there is no way.
   */
  route: Cell[];
  /** Steps (in mms cells) to the goal from each cell in the whole maze; -1 where there is no way. */
  distances: number[];
  reasons: Reasons[];
  events: MmsEvent[];
  /**
   * What each step falls behind a shortest way, in steps; after the goal each step of the search run does. Empty
   * where a step has no such measure.
   */
  loses: number[];
  /**
   * What had been scored by each frame, whether or not it was finished in the end; in seconds null before the first
   * run.
   */
  scores: (number | null)[];
  /** Only in seconds. */
  drive?: Drive;
  /** How other mice have the same contest: what `contest` is asked besides, and who can. Missing where none can. */
  again?: { with: { world: string; conditions: Fields }; mice: string[] };
}

/**
 * What a run of a contest in seconds is worth by the rules, in microseconds; where dead ends count, `value` is the
 * marks lost, in millionths.
 */
export interface DriveScore {
  gate_to_gate: number | null;
  rest_to_centre: number | null;
  /**
   * The part of the time in the maze before it that counts, and what is taken off for a mouse that was not touched.
   */
  maze_time: number;
  bonus: number;
  value: number;
  /** The one that counts in the end. */
  best: boolean;
}

/** One run of a contest in seconds. Times are microseconds on the maze's clock. */
export interface DriveRun {
  kind: 'search' | 'home' | 'speed' | 'laps';
  begin: number;
  end: number;
  /** Left the start cell, first entered a goal, first in the middle of a goal; null where that never came. */
  gate_out: number | null;
  gate_in: number | null;
  centre: number | null;
  /** Of a run of laps: left the start cell again, after each lap. */
  laps?: number[];
  /** Of a search that entered a goal, where dead ends count: what it saw before that, in how many steps. */
  dead_ends?: { seen: number; all: number; steps: number; fewest_steps: number };
  /** When it began: times of the fastest route known to exist, and of the fastest that may exist; null for none. */
  known: number | null;
  possible: number | null;
  /**
   * How it ended, in the words of the record: "done", "slid", "no route left"; null in a world in which nothing
   * goes wrong.
   */
  ended: string | null;
  /** Where the mouse crashed, which ended the run; null where it did not. */
  crash: { time: number; cell: Cell } | null;
  /** The frame in which it begins. */
  frame: number;
  /** Its points in the path: from that one to the one before `to`. */
  from: number;
  to: number;
  /** Null where it does not count. */
  score: DriveScore | null;
}

/**
 * A path, point by point. Between two points of a run the acceleration is even; turns have points dense enough to
 * be drawn as lines. Where the speed leaps (robots with published times), two points have the same time.
 */
export interface DrivePath {
  /** Microseconds. */
  t: number[];
  /** Cells from the south-west corner: the middle of cell (0,0) is (0.5, 0.5). */
  x: number[];
  y: number[];
  /** Eighths of a turn clockwise from north, without a leap within a run. */
  heading: number[];
  /** mm/s. */
  v: number[];
  /** mm/s² along the path from this point to the next one. */
  a: number[];
}

/**
 * Both mice of a contest in the physical world: the true one drives the path, the other one is where it believes to
 * be. Lengths are in cells, times in microseconds.
 */
export interface DriveBodies {
  /** From the middle of the axle. */
  front: number;
  back: number;
  half_width: number;
  /** Radius of the corners. */
  rounding: number;
  /**
   * Of the path's points, one by one, headings without a leap from the true ones; without points of a mouse whose
   * program does not tell.
   */
  belief: { x: number[]; y: number[]; heading: number[] };
  /** Where its infrared sensors are, and where they look: eighths of a turn clockwise from ahead. */
  beams: { ahead: number; left: number; angle: number }[];
  /** Of each point of the path one by each beam: how far the wall is that they read; 0 for none. */
  distances: number[];
  /**
   * What it read of the walls to the left, ahead and to the right of a cell as it entered it, in eighths of a nat:
   * above 0 for a wall. Headings in eighths of a turn.
   */
  looks: { time: number; x: number; y: number; heading: number; evidence: number[] }[];
  /** Where the true mouse touched a wall. */
  touches: { time: number; x: number; y: number; crash: boolean }[];
}

/** What only a play in seconds has. */
export interface Drive {
  /** `cell`: the side of a cell in mm; `hash`: of its tables. */
  robot: { name: string; cell: number; hash: string };
  /**
   * Times in microseconds. `maze_time_divisor`: 30 where a thirtieth of the time in the maze counts, 0 where none
   * does; `touch_penalty`: added to a run after a touch; `untouched_bonus`: taken off before the first.
   */
  rules: {
    name: string;
    source: string;
    time_limit: number;
    most_runs: number;
    maze_time_divisor: number;
    touch_penalty: number;
    untouched_bonus: number;
    gate_to_gate: boolean;
    /** Where laps count, and not runs. */
    counts?: 'lap';
  };
  decisions: number;
  replanned: number;
  runs: DriveRun[];
  path: DrivePath;
  /** The fastest run that the maze allows, from time 0; without points where there is none. */
  best: DrivePath;
  /** Of a record in the physical world that has a trace. */
  bodies?: DriveBodies;
}

/** A number of a robot file. */
export interface RobotKey {
  /** With its section: `straight.speed`. */
  name: string;
  meaning: string;
  unit: string;
  /** In words, with the unit. */
  range: string;
  low: number;
  high: number;
  /** In which forms of the file it has a meaning. */
  with: 'always' | 'curves' | 'turns' | 'search_speed' | 'search_times' | 'body';
  needed: boolean;
  kind: 'number' | 'whole' | 'number_or_false' | 'yes_or_no' | 'choice';
  /** The texts that a choice may have. */
  choices: string[];
  of_diagonals: boolean;
}

/** A number, or the sensors of a list with their numbers by name. */
export type RobotValue = number | boolean | string | Record<string, number>[];

/** A kind of turn: its path and what it takes. Lengths in mm, null where only times are known; places in cells. */
export interface RobotTurn {
  turn: string;
  /** The fastest first. */
  speeds: { speed: number; ms: number }[];
  /** Through two cells by two: the lead, the curve, the lead. */
  path: Cell[];
  /** Walls from post to post as [x, y, x, y]: those that must be open, and those that may stand. */
  open: [number, number, number, number][];
  standing: [number, number, number, number][];
  lead_in: number | null;
  lead_out: number | null;
  length: number | null;
  clearance: number | null;
}

/** What follows from a robot; times in milliseconds. */
export interface RobotResult {
  /** In one line. */
  line: string;
  turns: RobotTurn[];
  /** From one turn at `speed` to the next: so many steps of that length in so many milliseconds. */
  straights: { kind: string; step: string; speed: number; times: { steps: number; ms: number }[] }[];
  /** The moves of a search. */
  search: {
    cell: number;
    turn: number;
    back: number;
    quarter: number;
    half_cell: number;
    known_2: number;
    known_8: number;
  };
  /** The hash of its tables. */
  tables: string;
}

/** The fastest route of a maze as `labmouse route --format json` has it; times in microseconds. */
export interface RobotRoute {
  name: string;
  time_us: number;
  gate_to_gate_us: number;
  without_diagonals_us: number | null;
  diagonal_gain: number | null;
  small_turns_us: number | null;
  gain_over_small_turns: number | null;
  cells: number;
  fewest_cells: number;
  fewest_cells_us: number | null;
  route: string;
  segments: unknown[];
  path: DrivePath;
}

/** A number of a robot by its key, in the key's unit, and how far it is varied. */
export interface VariedRange {
  key: string;
  from: number;
  to: number;
}

/** Where one route stays the fastest, from the first value planned to the last; null where none is. */
export type RouteRegion = {
  from: number;
  to: number;
  route: string;
  time_from_us: number;
  time_to_us: number;
  runner_up: string | null;
  /** By how much the best other route is slower. */
  margin: number | null;
} | {
  from: number;
  to: number;
  route: null;
  refusal: string;
};

/** Which route wins for which robot, as `labmouse route --vary --format json` has it. */
export interface RouteRegions {
  labmouse: string;
  robot: string;
  maze: string;
  vary: VariedRange & { unit: string };
  and: VariedRange & { unit: string } | null;
  plans: number;
  routes: { name: string; cells: number; route: string; passes: [number, number, string][] }[];
  rows: { at: number | null; regions: RouteRegion[] }[];
}

/** A sentence about a robot, and the key that it belongs to; empty for none. */
export interface RobotSentence {
  key: string;
  text: string;
}

/**
 * `robot`: the text of its file, what stands there, and what follows; `result` is null where there are problems.
 */
export interface RobotAnswer {
  text: string;
  values: Record<string, RobotValue>;
  /** Those that have a meaning beside those values. */
  keys: string[];
  problems: (RobotSentence & { line: number; column: number })[];
  remarks: RobotSentence[];
  result: RobotResult | null;
  route: RobotRoute | null;
  /** Why there is none in that maze; empty where nothing is wrong. */
  no_route: string;
}

/** The results of a race as `labmouse race --format json` writes them. */
export interface RaceResults {
  labmouse: string;
  compiler: string;
  processor: string;
  seed: number;
  stopped: boolean;
  groups: RaceGroup[];
  skipped: { path: string; reasons: string[] }[];
}

/** What else stands in results, by its key: figures that one world has, or what may be missing. */
export type Fields = Record<string, unknown>;

export interface RacedMaze extends Fields {
  name: string;
  width: number;
  height: number;
}

/** One contest in the results of a race; docs/reference/results.md has the fields. */
export interface ContestResult extends Fields {
  maze: string;
  outcome: string;
}

export interface RacedMouse extends Fields {
  name: string;
  runs: number;
  interval: [number, number] | null;
  mean_ratio: number | null;
  results: ContestResult[];
}

/** A race in one world, best mouse first; `worlds.json` knows what else stands in it. */
export interface RaceGroup extends Fields {
  world: string;
  /** How its mice are scored, in one line. */
  formula: string;
  /** What `labmouse race` says below its table, line by line; missing in results of older versions. */
  notes?: string[];
  mazes: RacedMaze[];
  mice: RacedMouse[];
}

/** A column of a leaderboard, which shows a field of each mouse. */
export interface ShownColumn {
  /** The field: a number, or a list with both ends of an interval. */
  key: string;
  title: string;
  meaning: string;
  digits: number;
  factor?: number;
  higher_is_better?: boolean;
}

/** How races in a world are shown. */
export interface ShownWorld {
  /** Of scores and their differences. */
  unit: string;
  /** What a contest without a score counts in means; null where it has no place there. */
  failure_score: number | null;
  /** The field of a maze with its best possible score, and what it is multiplied by. */
  bound: { key: string; unit: number };
  bound_meaning: string;
  columns: ShownColumn[];
  /**
   * Where it is not the field `score` of a contest: the field inside of which field, and what it is multiplied by.
   */
  score?: { key: string; inner: string; unit: number };
  /** Whether `losses` knows where its contests lose their steps. */
  in_steps?: boolean;
  /** Whether `contest` runs a contest there again. */
  plays?: boolean;
}

/** `worlds.json`: the tables of all worlds that the core knows. */
export type ShownWorlds = {
  names: string[];
  table: ShownWorld;
}[];

/** `compare`: what the differences of two mice in the same mazes show. */
export interface PairedDifference {
  count: number;
  mean: number;
  interval: [number, number];
  below: number;
  equal: number;
  above: number;
  sign_test: number;
  /** Of the sign-flip test, two-sided. */
  p: number;
  /** better, worse, no difference shown, or too few mazes. */
  verdict: string;
}

/** A comparison until a verdict, with the settings of its world beside `world`, by their names. */
export interface ComparisonOrder {
  mice: string[];
  seed: number;
  /** Mazes. */
  most: number;
  better_by: number;
  alpha: number;
  beta: number;
  /** bets or gsprt; default: bets. */
  test?: string;
  world?: string;
  mazes?: MazeData[];
  generator?: string;
  width?: number;
  height?: number;
  loops?: number;
}

/** Maze by maze: a share of each mouse. */
export type Shares = (number | null)[][];

/** As `labmouse compare --format json`. */
export interface Comparison extends Fields {
  first: string;
  /** Mazes. */
  raced_in: number;
  skipped: number;
  exact: boolean;
  alpha: number;
  better_by: number;
  candidates: ComparedMouse[];
}

export interface ComparedMouse {
  mouse: string;
  verdict: string;
  pairs: number;
  share: number;
  first_share: number;
  difference: number;
  interval: [number, number];
}

/** `open`: what a dropped file turned out to be. */
export type Opened = {
  kind: 'maze';
  maze: MazeData;
  /** What the user should know of how it was read, a sentence each. */
  notes: string[];
} | {
  kind: 'record';
  play: Play;
} | {
  kind: 'results';
  results: RaceResults;
} | {
  kind: 'robot';
  name: string;
  text: string;
};

/**
 * What a report page carries in its first block. The records are in the second, so that the table need not wait for
 * them. `mazes`: by name, as the link of `link`.
 */
export interface Report {
  labmouse: 'report';
  format: 2;
  version: string;
  results: RaceResults;
  mazes: Record<string, string>;
}

/** The second block: records in their packed form, which only the core reads. */
export interface ReportRecords {
  records: PackedRecord[];
  /** How many more there were that did not fit. */
  left_out: number;
}

export interface PackedRecord extends Fields {
  mouse: string;
  maze: string;
  seed?: number;
}

/** `losses`: where contests lose their steps. */
export interface Losses {
  contests: number;
  finished: number;
  bound: number | null;
  mean_score: number | null;
  search: number[];
  speed: number[];
  points: number[];
}

/** How every call ends that did not succeed. */
export interface Failure {
  error: string;
  problems: Problem[];
}

/** A mouse that held its contests in the page before a race: one in each maze, with the seed of that race. */
export interface PlayedMouse {
  name: string;
  spec: string;
  contests: { record: string; started: boolean; microseconds: number }[];
}

/** What is to be said to the program of a contest, line by line, and how far the contest is. */
export interface ProgramLines {
  contest: number;
  lines: string[];
  ended: boolean;
  steps: number;
}

/** How a program ended that should not have. `line` is one of the program, from 1. */
export type ProgramEnd = {
  kind: 'failed';
  message: string;
  line?: number;
} | {
  kind: 'exited';
  code: number;
} | {
  kind: 'silent';
  seconds: number;
} | {
  kind: 'printed';
  what: string;
};

/** What a user should know of a line. `side` is of a wall, seen from `cell`. */
export interface LiveFinding {
  kind: 'restart' | 'outside' | 'open_border' | 'contradiction' | 'false_wall' | 'missed_wall';
  line: number;
  cell: Cell | null;
  side: HeadingName | null;
  /** The line of `labmouse live`. */
  words: string;
}

/** What a real robot has sent so far. */
export interface LiveState {
  stream: number;
  /** The map; walls that it has not seen are open. */
  maze: MazeData;
  /** The unseen walls of each cell: 1 north, 2 east. */
  unseen: number[];
  /** The map as `labmouse live --save` writes it. */
  drawing: string;
  pose: { cell: Cell; heading: HeadingName } | null;
  /** The route that the robot plans: its cell, then where it turns. */
  route: Cell[];
  /** The newest value of each field. */
  fields: Record<string, string>;
  /** Of the lines that this call read. */
  values: {
    line: number;
    /** mm/s */
    v: number | null;
    /** mV */
    batt: number | null;
  }[];
  /** Of the lines that this call read. */
  findings: LiveFinding[];
  contradictions: LiveFinding[];
  /** False and missed walls of the map. */
  wrong: LiveFinding[];
  /** What `labmouse live --robot` prints; empty without a robot. */
  advice: string;
  /** The line for the robot; empty if no route is known. */
  plan: string;
  lines: number;
  noise: number;
  restarts: number;
}

/** Every function of the core: what it is asked and what it answers. `bytes` goes beside the request. */
export interface Calls {
  about: {
    request: Record<string, never>;
    answer: About;
  };
  /** The behaviour signature of `labmouse bench`. */
  signature: {
    request: Record<string, never>;
    answer: { signature: string };
  };
  /** Nanoseconds of a distance field, as `labmouse bench` has them. */
  speed: {
    request: Record<string, never>;
    answer: { distance_ns: Record<string, Record<string, number>> };
  };
  builtin_maze: {
    request: { name: string };
    answer: { maze: MazeData };
  };
  /** `loops`: the share, 0 to 1, of the remaining inner walls to take away. */
  make_maze: {
    request: { generator: string; width: number; height: number; seed: number; loops: number };
    answer: { maze: MazeData };
  };
  /** A file of any kind, its content as bytes. A record without a maze takes `maze`. */
  open: {
    request: { name: string; maze?: MazeData };
    bytes: Uint8Array;
    answer: Opened;
  };
  inspect: {
    request: { maze: MazeData };
    answer: Inspection;
  };
  /** The maze as a file: text, or bytes for the binary format. */
  write_maze: {
    request: { maze: MazeData; format: string };
    answer: { file_name: string; text?: string; bytes?: number[] };
  };
  /** A maze as a text for links: letters, digits, - _ and . only; and back. */
  link: {
    request: { maze: MazeData };
    answer: { link: string };
  };
  read_link: {
    request: { link: string };
    answer: { maze: MazeData };
  };
  /**
   * A robot that the page brings (`built_in`), with those values, or of the text in `bytes`; and the best route of
   * a maze.
   */
  robot: {
    request: {
      name: string;
      built_in?: string;
      values?: Record<string, RobotValue>;
      maze?: MazeData;
    };
    bytes?: Uint8Array;
    answer: RobotAnswer;
  };
  /**
   * Which route of a maze wins for which robot, as one or two numbers of it vary; the robot as for `robot`. The
   * picture is that of `labmouse route --vary --svg`.
   */
  regions: {
    request: {
      name: string;
      built_in?: string;
      values?: Record<string, RobotValue>;
      maze: MazeData;
      vary: VariedRange;
      and?: VariedRange;
    };
    bytes?: Uint8Array;
    answer: { regions: RouteRegions; svg: string };
  };
  /**
   * A contest of a built-in mouse in any world, as `labmouse run MOUSE MAZE --seed N --explain`. The settings of
   * the world stand beside `world`, by their names, as for `race`; or `conditions` are those of a race there, as
   * results have them.
   */
  contest: {
    request: Fields & { world?: string; mouse: string; maze: MazeData; seed: number; conditions?: Fields };
    answer: { play: Play; record: string };
  };
  /** A packed record of a report. A mouse of the built-in mice has its reasons again. */
  unpack: {
    request: { record: PackedRecord; maze: MazeData };
    answer: { play: Play; record: string };
  };
  /**
   * A race in the one thread that the page has: keep it small. Without mice: all of the built-in mice. The settings
   * of its world stand beside `world`, by their names.
   */
  race: {
    request: Fields & {
      mice: string[];
      mazes: MazeData[];
      seed: number;
      runs: number;
      world?: string;
      played?: PlayedMouse[];
    };
    answer: { results: RaceResults };
  };
  /** Means of a mouse in the same mazes as another. */
  compare: {
    request: { differences: number[]; seed?: number };
    answer: PairedDifference;
  };
  /**
   * Contests of one batch of a comparison, as those of `labmouse compare`: the share of the best possible score of
   * each mouse in each maze, null where the maze does not count. `begin`: the number of its first maze, a multiple
   * of 32. With `mazes` these are drawn from; without, they are generated. The first mouse is compared with the
   * others; those that are decided may be left out.
   */
  paired_shares: {
    request: ComparisonOrder & Fields & { begin: number };
    answer: { shares: Shares };
  };
  /** The comparison of mice by the shares of all batches so far. Once it is `over`, no more are needed. */
  verdict: {
    request: ComparisonOrder & Fields & { shares: Shares };
    answer: { comparison: Comparison; over: boolean };
  };
  /**
   * Where contests in steps in one maze lose their steps; labmouse/lab/replays/lost_steps.hpp says what that means.
   * Lists run over cells; those that were not finished are left out of all but `contests`. `points` is what the
   * mean contest loses of its score in that cell; they add up to `mean_score` - `bound`.
   */
  losses: {
    request: { maze: MazeData; contests: { mouse: string; seed: number }[]; budget?: number };
    answer: Losses;
  };
  /**
   * What a mouse with that knowledge believed: steps to the goal from each cell, all unknown walls open, frame by
   * frame: frames * cells numbers of 16 bits in `bytes`, 65535 where there is no way.
   */
  beliefs: {
    request: { maze: MazeData; known: number[]; frames: number; stride: number };
    answer: { bytes: Uint8Array };
  };
  /** A picture (SVG) of a maze, or of a record's text in `bytes`. */
  picture: {
    request: { maze: MazeData } | Record<string, never>;
    bytes?: Uint8Array;
    answer: { svg: string };
  };
  /**
   * Begins a contest in steps of a program that the page runs. `name` may be empty; `spec` is the program for the
   * command line. With `races` the seed is that of a race, from which the contest has its own.
   */
  program_begin: {
    request: {
      name: string;
      spec: string;
      maze: MazeData;
      seed: number;
      races?: boolean;
      budget?: number;
    };
    answer: ProgramLines;
  };
  /**
   * What the program wrote, to its standard output and to its standard error, with all line ends; or how it ended.
   */
  program_hear: {
    request: { contest: number; output?: string; printed?: string; end?: ProgramEnd };
    answer: ProgramLines;
  };
  /** Ends a contest, which counts as interrupted where it was not over. */
  program_end: {
    request: { contest: number };
    answer: {
      play: Play;
      record: string;
      packed: PackedRecord;
      started: boolean;
      microseconds: number;
    };
  };
  /**
   * Begins to read a real robot, in a maze that is known (`maze`) or of that size. With `robot`, its name, it is
   * given as for `robot`, and the routes of the map are planned.
   */
  live_begin: {
    request: {
      maze?: MazeData;
      width?: number;
      height?: number;
      robot?: string;
      built_in?: string;
      values?: Record<string, RobotValue>;
    };
    bytes?: Uint8Array;
    answer: LiveState;
  };
  /** The next bytes of the robot, in any pieces. */
  live_feed: {
    request: { stream: number };
    bytes: Uint8Array;
    answer: LiveState;
  };
  live_end: {
    request: { stream: number };
    answer: Record<string, never>;
  };
}

export type CallName = keyof Calls;
