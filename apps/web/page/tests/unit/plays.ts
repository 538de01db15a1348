// Small plays for tests, written by hand.
import type { MazeData, Play } from '../../src/core/types';

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

/** Explores by three steps, goes back from the goal by one, resets, runs by three steps. */
export function steps(changes: Partial<Play> = {}): Play {
  return {
    world: 'steps',
    mouse: 'hand',
    maze,
    rules: { budget: 1000, exploration_factor: 30, stride: 3 },
    seed: 1,
    outcome: 'solved',
    solved: true,
    score: 3 + 5 / 30,
    bound: 3 + 4 / 30,
    optimum: 3,
    exploration_steps: 5,
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
    scores: [0, 1, 2, 3, 4, 5, 35, 65, 95].map((thirtieths) => thirtieths / 30),
    ...changes,
  };
}

/** A program for mms that turns, goes on half a cell at a time and draws. */
export function mms(changes: Partial<Play> = {}): Play {
  return steps({
    world: 'mms',
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
