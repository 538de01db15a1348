import { describe, expect, it } from 'vitest';
import type { RaceResults } from '../../src/core/types';
import { cellText } from '../../src/race/cell-text';
import { boardsOf } from '../../src/results/contests';
import { cellAt, matrixLayout, moved, widthFor } from '../../src/race/matrix-layout';
import { hardness, orderedMazes } from '../../src/race/maze-order';
import { toneLabels, toneOf } from '../../src/race/scale';

describe('the layout of the matrix', () => {
  it('fits 261 mazes into the room, without their names', () => {
    const layout = matrixLayout(261, 20, 1100, 'fit');
    expect(layout.width).toBeCloseTo(1100);
    expect(layout.top).toBeLessThan(10);
  });
  it('scrolls on a phone rather than making cells too small to point at', () => {
    expect(matrixLayout(261, 20, 260, 'fit').width).toBeGreaterThan(700);
    expect(widthFor(261, 260)).toBe('wide');
    expect(widthFor(261, 1100)).toBe('fit');
    expect(widthFor(0, 260)).toBe('fit');
  });
  it('fits on paper at any rate', () => expect(matrixLayout(261, 20, 550, 'paper').width).toBeCloseTo(550));
  it('names the mazes where there is room', () => {
    expect(matrixLayout(40, 5, 1000, 'fit').top).toBeGreaterThan(50);
    expect(matrixLayout(261, 5, 1000, 'wide').top).toBeGreaterThan(50);
  });
  it('finds the cell at a point, and none beside', () => {
    const layout = matrixLayout(40, 5, 1000, 'fit');
    expect(cellAt(layout, 26, layout.top + 1)).toEqual({ row: 0, column: 1 });
    expect(cellAt(layout, 999, layout.height - 1)).toEqual({ row: 4, column: 39 });
    for (const [x, y] of [
      [-1, 100],
      [1001, 100],
      [5, layout.top - 1],
      [5, layout.height],
    ])
      expect(cellAt(layout, x, y)).toBeNull();
  });
  it('moves a cursor by keys and keeps it inside', () => {
    const layout = matrixLayout(40, 5, 1000, 'fit');
    expect(moved({ row: 1, column: 1 }, 'ArrowRight', layout)).toEqual({ row: 1, column: 2 });
    expect(moved({ row: 1, column: 1 }, 'ArrowUp', layout)).toEqual({ row: 0, column: 1 });
    expect(moved({ row: 0, column: 0 }, 'ArrowUp', layout)).toEqual({ row: 0, column: 0 });
    expect(moved({ row: 4, column: 35 }, 'PageDown', layout)).toEqual({ row: 4, column: 39 });
    expect(moved({ row: 4, column: 35 }, 'Home', layout)).toEqual({ row: 4, column: 0 });
    expect(moved({ row: 0, column: 0 }, 'a', layout)).toBeNull();
    expect(moved({ row: 0, column: 0 }, 'constructor', layout)).toBeNull();
  });
});

describe('the scale', () => {
  it('has a tone and a label for every ratio', () => {
    expect([1, 1.02, 1.15, 1.2, 1.5, 2, 27].map(toneOf)).toEqual([0, 1, 2, 3, 4, 5, 6]);
    expect(toneLabels).toHaveLength(7);
  });
});

const result = (maze: string, score: number | null, seed = 1) => ({
  maze,
  seed,
  outcome: score === null ? 'out of budget' : 'finished',
  score,
  search_steps: 30,
  speed_steps: score === null ? null : 20,
});
const inSteps = {
  world: 'steps',
  mazes: [
    { name: 'mazes/easy.txt', width: 16, height: 16, optimum: 19, bound: 20 },
    { name: 'mazes/closed.txt', width: 8, height: 8, optimum: null, bound: null },
    { name: 'mazes/hard.txt', width: 16, height: 16, optimum: 9, bound: 10 },
  ],
  mice: [
    { name: 'one', contestant: true, results: [result('mazes/easy.txt', 22), result('mazes/hard.txt', null)] },
    {
      name: 'dice',
      contestant: true,
      results: [
        result('mazes/easy.txt', 30),
        result('mazes/easy.txt', 20, 2),
        result('mazes/hard.txt', 20),
        result('mazes/hard.txt', null, 2),
      ],
    },
    { name: 'oracle', contestant: false, results: [result('mazes/easy.txt', 20)] },
  ],
};
const results = { groups: [inSteps] } as unknown as RaceResults;

describe('the contests of a race', () => {
  const [board] = boardsOf(results);

  it('are sorted into cells, with the mean ratio of the finished ones', () => {
    expect(board.cells[1][0]).toMatchObject({ finished: 2, ratio: 1.25 });
    expect(board.cells[1][2]).toMatchObject({ finished: 1, ratio: 2 });
    expect(board.cells[0][2]).toMatchObject({ finished: 0, ratio: null });
    expect(board.cells[0][1].contests).toEqual([]);
  });
  it('say in words what a cell shows', () => {
    expect(cellText(board, 0, 0)).toBe(
      'one in easy (16×16): finished, score 22, search 30 steps, speed run 20 steps (1 beyond the shortest); best 20, score / best 1.100',
    );
    expect(cellText(board, 0, 2)).toBe('one in hard (16×16): out of budget; best 10');
    expect(cellText(board, 1, 2)).toBe(
      'dice in hard (16×16): finished 1 of 2, mean score of these 20.000; best 10, score / best 2.000',
    );
    expect(cellText(board, 0, 1)).toBe('one in closed (8×8): the goal cannot be reached');
    expect(cellText(board, 2, 2)).toBe('oracle in hard (16×16): no contest');
  });
  it('order the mazes by name, by best possible score and by how hard they were', () => {
    expect(orderedMazes(board, 'name')).toEqual([1, 0, 2]);
    expect(orderedMazes(board, 'best possible')).toEqual([2, 0, 1]);
    expect(orderedMazes(board, 'how hard')).toEqual([0, 2, 1]);
    expect(hardness(board, 1)).toBeNull();
  });
  it('survive numbers that are none, and contests in mazes that nobody knows', () => {
    const odd = structuredClone(results) as RaceResults;
    const [group] = odd.groups;
    group.mazes[0].bound = 'x' as unknown as number;
    group.mice[0].results.push(result('elsewhere', 5) as never, result('mazes/hard.txt', 'NaN' as never) as never);
    const [board] = boardsOf(odd);
    expect(board.mazes[0].bound).toBeNull();
    expect(board.cells[0][2].contests).toHaveLength(2);
    expect(board.cells[0][2].finished).toBe(0);
  });
  it('have boards for seconds and for worlds that nobody knows', () => {
    const maze = { name: 'a', width: 16, height: 16, bound_us: 5_000_000, bound: 5, fastest_us: 5_500_000 };
    const result = { maze: 'a', seed: 3, outcome: 'finished' };
    const group = (world: string, score: unknown, none: unknown) => ({
      world,
      formula: 'f',
      mazes: [maze],
      mice: [
        {
          name: 'm',
          runs: 2,
          mean_score: 6,
          results: [
            { ...result, score },
            { ...result, score: none },
          ],
        },
      ],
    });
    const groups = [group('seconds', { value: 6_000_000, run: 2 }, null), group('toy', 6, 'lost')];
    const boards = boardsOf({ ...results, groups } as unknown as RaceResults);
    expect(boards.map(({ world }) => world)).toEqual(['seconds', 'toy']);
    for (const { mazes, cells } of boards) {
      expect(mazes[0].bound).toBe(5);
      expect(cells[0][0]).toMatchObject({ finished: 1, ratio: 1.2 });
      expect(cells[0][0].contests.map(({ score, seed }) => [score, seed])).toEqual([
        [6, 3],
        [null, 3],
      ]);
    }
  });
  it('have a board for mms too, and none where no mice raced', () => {
    const group = {
      world: 'mms' as const,
      formula: 'f',
      mazes: [{ name: 'a', width: 16, height: 16, best_run: 10, best_score: 20 }],
      mice: [
        {
          name: 'mms:x',
          results: [
            {
              maze: 'a',
              outcome: 'gave-up',
              end: 'gave up',
              finished: false,
              score: 2000,
              possible_score: 20,
              ratio: null,
              errors: [],
            },
          ],
        },
      ],
    };
    const boards = boardsOf({ ...results, groups: [group] } as unknown as RaceResults);
    expect(boards.map(({ world }) => world)).toEqual(['mms']);
    expect(boards[0].cells[0][0]).toMatchObject({ finished: 0, ratio: null });
    expect(cellText(boards[0], 0, 0)).toBe('mms:x in a (16×16): gave up; best 20');
  });
});
