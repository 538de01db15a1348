// Small plays for tests, written by hand.
import type { MazeData, Play, Traits } from '../../src/core/types';

/**
 * Three by two cells; the goal is (2,0):
 *
 *     o---o---o---o
 *     |           |
 *     o   o---o   o
 *     | S |     G |
 *     o---o---o---o
 */
export const maze: MazeData = {
  name: 'small',
  width: 3,
  height: 2,
  walls: [2 + 4 + 8, 1 + 4 + 8, 2 + 4, 1 + 8, 1 + 4, 1 + 2],
  start: [0, 0],
  heading: 'north',
  goals: [[2, 0]],
};

const inSteps: Traits = {
  clock: 'steps',
  unit: '',
  digits: 3,
  bound: 'the best possible score',
  runs: ['search', 'speed run'],
  draws: false,
  pictured: true,
};

/** Explores by three steps, goes back from the goal by one, resets, runs by three steps. */
export function steps(changes: Partial<Play> = {}): Play {
  return {
    world: 'steps',
    traits: inSteps,
    mouse: 'hand',
    maze,
    rules: { budget: 1000, search_factor: 30, stride: 3 },
    seed: 1,
    outcome: 'finished',
    finished: true,
    score: 3 + 5 / 30,
    bound: 3 + 4 / 30,
    optimum: 3,
    search_steps: 5,
    speed_steps: 3,
    discovered: 1,
    visited: 5 / 6,
    last_words: '',
    counts: [],
    checked: '',
    ended: true,
    clock: [0, 1, 2, 3, 4, 5, 6, 7, 8],
    x: [1, 1, 5, 5, 5, 1, 1, 5, 5],
    y: [1, 3, 3, 1, 3, 1, 3, 3, 1],
    heading: [0, 0, 2, 4, 4, 0, 0, 2, 4],
    run: [0, 0, 0, 0, 0, 1, 1, 1, 1],
    action: ['1', 'right, 2', 'right, 1', '-1', 'reset', '1', 'right, 2', 'right, 1'],
    blocked: [false, false, false, false, false, false, false, false],
    left: [0, 0, 0, 0, 0, 0, 0, 0],
    ahead: [1, 0, 0, 0, 1, 1, 0, 0],
    right: [0, 2, 1, 1, 2, 0, 2, 1],
    // North sides of the six cells, then their east sides.
    known: [0, 3, 2, 0, 0, 0, 0, 3, 0, 1, 1, 0],
    goal_frame: 3,
    reset_frame: 5,
    entered: [[3], [4, 5], [2], [5], [0], [3], [4, 5], [2]],
    route: [
      [0, 0],
      [0, 1],
      [2, 1],
      [2, 0],
    ],
    distances: [3, 1, 0, 2, 2, 1],
    reasons: [],
    events: [],
    loses: [0, 0, 0, 1, 0, 0, 0, 0],
    scores: [0, 1, 2, 3, 4, 5, 35, 65, 95].map((thirtieths) => thirtieths / 30),
    ...changes,
  };
}

/** A program for mms that turns, goes on half a cell at a time and draws. */
export function mms(changes: Partial<Play> = {}): Play {
  return steps({
    world: 'mms',
    traits: { ...inSteps, clock: 'seconds', digits: 1, runs: ['running'], draws: true, pictured: false },
    loses: [],
    rules: null,
    clock: [0, 0.5, 0.5, 1.25, 2],
    x: [1, 1, 1, 2, 1],
    y: [1, 2, 3, 4, 1],
    heading: [0, 0, 0, 1, 0],
    run: [0, 0, 0, 0, 0],
    action: ['moveForwardHalf', 'moveForwardHalf', 'moveForwardHalf', 'ackReset'],
    blocked: [false, false, false, false],
    left: [],
    ahead: [],
    right: [],
    known: [],
    goal_frame: null,
    reset_frame: null,
    entered: [[], [3], [], [0]],
    events: [
      { frame: 0, kind: 'colour', cell: [0, 0], colour: 'G' },
      { frame: 1, kind: 'text', cell: [1, 1], text: 'abcdefgh' },
      { frame: 2, kind: 'wall', cell: [1, 0], side: 'west', there: true },
      { frame: 2, kind: 'wall', cell: [0, 0], side: 'south', there: true },
      { frame: 3, kind: 'clear colours' },
      { frame: 3, kind: 'colour', cell: [2, 1], colour: 'k' },
      { frame: 4, kind: 'clear texts' },
      { frame: 4, kind: 'wall', cell: [0, 0], side: 'east', there: false },
    ],
    scores: [0, 1, 2, 3, 4],
    ...changes,
  });
}

/**
 * A contest in seconds in the same maze, of one cell a second: up, one cell to the right, stops and turns, is carried
 * back, and runs up again, evenly accelerated, then at a leap faster.
 */
export function seconds(changes: Partial<Play> = {}): Play {
  const run = {
    ...{ gate_out: null, gate_in: null, centre: null, known: null, possible: null, score: null },
    ...{ ended: null, crash: null },
  };
  return {
    ...steps(),
    world: 'seconds',
    traits: { ...inSteps, clock: 'seconds', unit: 's', runs: ['search', 'way home', 'speed run'] },
    loses: [],
    rules: null,
    outcome: 'finished',
    score: 1.5,
    bound: 1.25,
    optimum: 1.5,
    search_steps: 0,
    speed_steps: 0,
    clock: [0, 1, 3, 3, 5, 5.5],
    x: [1, 1, 3, 1, 1, 1],
    y: [1, 3, 3, 1, 2, 3],
    heading: [0, 0, 2, 0, 0, 0],
    run: [0, 0, 0, 2, 2, 2],
    action: ['ahead 1', 'right, 1', 'carried to the start', 'ahead 0.5', 'ahead 0.5'],
    blocked: [false, false, false, false, false],
    left: [],
    ahead: [],
    right: [],
    known: [0, -1, -1, 0, 0, 0, 0, 1, 0, 2, 2, 0],
    goal_frame: 2,
    reset_frame: 3,
    entered: [[3], [4], [], [], [3]],
    route: [],
    scores: [null, null, null, null, null, 1.5],
    drive: {
      robot: { name: 'hand', cell: 100, hash: '0' },
      rules: {
        name: 'thirtieth',
        source: '',
        time_limit: 6e8,
        most_runs: 5,
        maze_time_divisor: 30,
        touch_penalty: 0,
        untouched_bonus: 0,
        gate_to_gate: true,
      },
      decisions: 2,
      replanned: 1,
      runs: [
        { ...run, kind: 'search', begin: 0, end: 3e6, gate_out: 1e6, gate_in: 2e6, frame: 0, from: 0, to: 4 },
        {
          ...run,
          kind: 'speed',
          begin: 3e6,
          end: 5.5e6,
          gate_out: 4e6,
          gate_in: 5.5e6,
          frame: 3,
          from: 4,
          to: 8,
          score: { gate_to_gate: 1.5e6, rest_to_centre: 2.5e6, maze_time: 1e5, bonus: 0, value: 1.6e6, best: true },
        },
      ],
      path: {
        t: [0, 1e6, 2e6, 3e6, 3e6, 5e6, 5e6, 5.5e6],
        x: [0.5, 0.5, 1.5, 1.5, 0.5, 0.5, 0.5, 0.5],
        y: [0.5, 1.5, 1.5, 1.5, 0.5, 1.5, 1.5, 2],
        heading: [0, 0, 2, 6, 0, 0, 0, 0],
        v: [100, 100, 0, 0, 0, 100, 200, 200],
        a: [0, -100, 0, 0, 50, 0, 0, 0],
      },
      best: { t: [], x: [], y: [], heading: [], v: [], a: [] },
    },
    ...changes,
  };
}
