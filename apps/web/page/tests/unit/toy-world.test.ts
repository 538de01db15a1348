// A world that the page has never heard of: the race of tests/toy, whose results its native test keeps true.
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { RaceGroup, RaceResults } from '../../src/core/types';
import { cellText } from '../../src/race/cell-text';
import { boardOf, groupsOf } from '../../src/results/contests';
import { ratiosOf } from '../../src/race/curves-data';
import { columnsOf, orderedBy } from '../../src/race/leaderboard-columns';
import { pairsOf } from '../../src/race/duel-data';
import { worldOf } from '../../src/results/worlds';

const file = new URL('../../../../../tests/toy/results.json', import.meta.url);
const results = JSON.parse(readFileSync(file, 'utf8')) as RaceResults;
const [group] = groupsOf(results);
const board = boardOf(group);

describe('a world that nobody has told the page of', () => {
  it('has the unit, the titles and the columns that its results name', () => {
    const world = worldOf(group);
    expect([world.unit, world.title, world.limit]).toEqual([group.unit, `, ${group.world}`, 100]);
    const own = world.columns.slice(-1)[0];
    expect(own.title).toBe((group.columns as string[])[0]);
    for (const mouse of group.mice) {
      const [cell] = mouse.cells as string[];
      expect([own.value(mouse), own.show!(mouse)]).toEqual([Number(cell), cell]);
    }
  });
  it('has its bounds in microseconds, too', () => {
    const mazes = group.mazes.map((maze) => ({ ...maze, bound: undefined, bound_us: 2e6 }));
    const mice = group.mice.map((mouse) => ({ ...mouse, finished: 1 }));
    const other = { ...group, mazes, mice } as unknown as RaceGroup;
    expect(boardOf(other).mazes.map(({ bound }) => bound)).toEqual(mazes.map(() => 2));
  });
  it('ranks as the program does: by how many contests have a score, where the others have no place in means', () => {
    const columns = columnsOf(group, 2);
    expect(columns[orderedBy(group)].title).toBe('finished');
    expect(orderedBy({ ...group, world: 'steps', failure_score: undefined })).toBe(2);
    expect(columns[orderedBy({ ...group, failure_score: 100 })].title).toContain('score');
  });
  it('has a matrix of its scores over its bounds', () => {
    for (const mouse of group.mice)
      for (const contest of mouse.results) {
        const cell = board.cells[group.mice.indexOf(mouse)][board.mazes.findIndex(({ name }) => name === contest.maze)];
        expect(cell.contests.some(({ score, seed }) => score === contest.score && seed === contest.seed)).toBe(true);
      }
    expect(cellText(board, 0, 0)).toContain(board.mazes[0].short);
  });
  it('has distributions of all its contests, and duels without those that have no score', () => {
    const finished = group.mice[0].results.filter(({ score }) => score !== null).length;
    expect(ratiosOf(board, 0).ratios).toHaveLength(finished);
    expect(ratiosOf(board, 0).contests).toBe(group.mice[0].results.length);
    for (const { a, b, difference } of pairsOf(board, 0, 1, board.shows.limit)) expect(a - b).toBe(difference);
  });
});
