import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import type { Core } from '../../src/core/client';
import type { About, MazeData, PackedRecord, RaceResults } from '../../src/core/types';
import { readRecords, readReport } from '../../src/results/blocks';
import { loadedRace, type Sources } from '../../src/results/loaded';
import { find, shortNames, stem } from '../../src/results/names';

const pack = (json: unknown) => gzipSync(JSON.stringify(json)).toString('base64');
const group = { mazes: [{ name: 'a.txt', width: 8, height: 8 }], mice: [{ name: 'flood', results: [] }] };
const results = { groups: [group] };
const report = { labmouse: 'report', format: 2, version: '0.1.0', results, mazes: { 'a.txt': 'LINK', odd: 5 } };

describe('the report of a page', () => {
  it('is read, also where its text was broken into lines', async () => {
    const text = pack(report).replace(/(.{20})/g, '$1\n');
    expect(await readReport(text)).toEqual({ ...report, mazes: { 'a.txt': 'LINK' } });
  });
  it.each([
    ['is cut', pack(report).slice(0, -30)],
    ['is no base64', '<!DOCTYPE'],
    ['is empty', ''],
    ['is no JSON', gzipSync('{"labmouse":').toString('base64')],
  ])('is refused in words where it %s', async (_, text) => {
    await expect(readReport(text)).rejects.toThrow(/incomplete or damaged/);
  });
  it('is refused where it is of another format, with the version that made it', async () => {
    await expect(readReport(pack({ ...report, format: 3, version: '9.0' }))).rejects.toThrow(
      /format 3, made by labmouse 9\.0.*reads format 2/,
    );
    await expect(readReport(pack({ ...report, format: undefined }))).rejects.toThrow(/format undefined/);
  });
  it.each([
    ['something else', { labmouse: 'race' }],
    ['a list', [1]],
    ['null', null],
  ])('is refused where it is %s', async (_, json) => {
    await expect(readReport(pack(json))).rejects.toThrow(/not a labmouse report/);
  });
  it.each([
    ['no results', undefined],
    ['mice without contests', { groups: [{ ...group, mice: [{ name: 'flood' }] }] }],
    ['mice without names', { groups: [{ ...group, mice: [{ results: [] }] }] }],
    ['contests without a maze', { groups: [{ ...group, mice: [{ name: 'flood', results: [{ outcome: 'x' }] }] }] }],
    ['groups that are none', { groups: 5 }],
  ])('is refused where it has %s', async (_, odd) => {
    await expect(readReport(pack({ ...report, results: odd }))).rejects.toThrow(/has no results/);
  });
});

describe('the records of a page', () => {
  it('are read; what is none is left out', async () => {
    const record = { mouse: 'flood', maze: 'a', actions: 'x' };
    expect(await readRecords(pack({ records: [record, null, { mouse: 5 }], left_out: 3 }))).toEqual({
      records: [record],
      left_out: 3,
    });
  });
  it('are refused in words', async () => {
    await expect(readRecords(pack({ records: 1 }))).rejects.toThrow(/form/);
    await expect(readRecords(pack({ records: [] }).slice(0, 10))).rejects.toThrow(/incomplete or damaged/);
  });
});

describe('names of mazes', () => {
  it('are shortened to stems where these differ', () => {
    expect(stem('/long/way/13ye.txt')).toBe('13ye');
    expect(stem('contest-01')).toBe('contest-01');
    expect(stem('.hidden')).toBe('.hidden');
    expect(shortNames(['a/one.txt', 'b/one.txt', 'b/two.txt'])).toEqual(['a/one.txt', 'b/one.txt', 'two']);
  });
  it('find what was filed under them, or under the only one alike', () => {
    const values = new Map([
      ['a/one.txt', 1],
      ['b/two.txt', 2],
      ['c/two.txt', 3],
    ]);
    expect([find(values, 'a/one.txt'), find(values, 'one'), find(values, 'two'), find(values, 'three')]).toEqual([
      1,
      1,
      undefined,
      undefined,
    ]);
  });
});

describe('a loaded race', () => {
  const maze = (name: string, width = 8) => ({ name, width, height: 8 }) as MazeData;
  const calls: string[] = [];
  const core = {
    call: async (name: string, request: { name?: string; link?: string }) => {
      calls.push(name);
      return { maze: maze(request.name ?? request.link ?? '') };
    },
  } as unknown as Core;
  const record = (mouse: string, of: string, seed?: number): PackedRecord => ({ mouse, maze: of, seed });
  const sources = (more: Partial<Sources> = {}): Sources => ({
    core,
    ready: Promise.resolve({ mazes: [{ name: 'contest-01', width: 8, height: 8 }] } as About),
    links: new Map([['a.txt', 'LINK']]),
    opened: new Map([
      ['dropped', maze('dropped')],
      ['wide', maze('wide', 9)],
    ]),
    records: async () => [record('flood', 'a', 1), record('flood', 'a', 2), record('guest', 'b')],
    ...more,
  });
  const mazes = ['a.txt', 'x/contest-01.txt', 'dropped.txt', 'wide.txt', 'gone.txt'].map((name) => ({
    name,
    width: 8,
    height: 8,
  }));
  const raced = { groups: [{ mazes, mice: [] }] } as unknown as RaceResults;

  it('has its mazes from the report, from the page and from the core, where they fit', async () => {
    const race = loadedRace(raced, sources());
    expect((await race.maze('a.txt'))?.name).toBe('LINK');
    expect((await race.maze('x/contest-01.txt'))?.name).toBe('contest-01');
    expect((await race.maze('dropped.txt'))?.name).toBe('dropped');
    expect(await race.maze('wide.txt')).toBeNull();
    expect(await race.maze('gone.txt')).toBeNull();
  });
  it('reads its records once, when they are asked for', async () => {
    let reads = 0;
    const race = loadedRace(raced, sources({ records: async () => (++reads, [record('flood', 'a', 1)]) }));
    expect(reads).toBe(0);
    expect(await race.records('flood', 'a.txt')).toHaveLength(1);
    expect(await race.records('flood', 'b.txt')).toEqual([]);
    expect(reads).toBe(1);
  });
});
