import { describe, expect, it } from 'vitest';
import type { Core } from '../../src/core/client';
import type { About, MazeData, PackedRecord, Play, RaceResults } from '../../src/core/types';
import { contestPlay, recordOf } from '../../src/race/contest-play';
import { boardsOf, type Contest } from '../../src/results/contests';
import type { EarlyPage } from '../../src/page/page';
import type { LoadedRace } from '../../src/results/loaded';

const group = {
  world: 'steps',
  budget: 500,
  mazes: [{ name: 'a', width: 8, height: 8, bound: 10, optimum: 9 }],
  mice: ['ariadne', 'program:x', 'oracle'].map((name) => ({
    name,
    results: [{ maze: 'a', seed: 7, outcome: 'finished', score: 12 }],
  })),
};
const results = { groups: [group] } as unknown as RaceResults;

/** A page whose core answers `contest` and `unpack` with plays of those actions. */
function setup({
  run,
  record,
  score = 12,
  maze = true,
}: {
  run?: string[];
  record?: string[];
  score?: number;
  maze?: boolean;
}) {
  const asked: [string, Record<string, unknown>][] = [];
  const play = (action: string[]) => ({ play: { action, score, outcome: 'finished' } as Play, record: 'text' });
  const core = {
    async call(name: string, request: Record<string, unknown>) {
      asked.push([name, request]);
      if (name === 'unpack') return play(record!);
      if (!run) throw new Error('the core cannot run it');
      return play(run);
    },
  } as unknown as Core;
  const page = {
    core,
    ready: Promise.resolve({ mice: [{ name: 'ariadne' }] } as About),
    complain() {},
  } as unknown as EarlyPage;
  const packed: PackedRecord = { mouse: 'm', maze: 'a', seed: 7 };
  const race: LoadedRace = {
    results,
    maze: async () => (maze ? ({ name: 'a' } as MazeData) : null),
    records: async () => (record ? [packed] : []),
  };
  const open = (mouse: number) => contestPlay(page, race, boardsOf(results)[0], { mouse, maze: 0, position: 0 });
  return { asked, open };
}

describe('the replay of a contest', () => {
  it('is run again with its seed and budget where there is no record', async () => {
    const { asked, open } = setup({ run: ['a'] });
    expect(await open(0)).toMatchObject({ remark: '' });
    expect(asked).toEqual([
      ['contest', { world: 'steps', mouse: 'ariadne', maze: { name: 'a' }, seed: 7, conditions: { budget: 500 } }],
    ]);
  });
  it('tells where this version behaves differently', async () => {
    expect((await setup({ run: ['a'], score: 13 }).open(0)).remark).toMatch(/behaves differently.*12.*13/);
  });
  it('takes the run, which has reasons, where its actions are those of the record', async () => {
    const { asked, open } = setup({ run: ['a', 'b'], record: ['a', 'b'] });
    expect(await open(0)).toMatchObject({ remark: '' });
    expect(asked.map(([name]) => name).sort()).toEqual(['contest', 'unpack']);
  });
  it('takes the record, and tells, where the run differs', async () => {
    const { play, remark } = await setup({ run: ['a', 'c'], record: ['a', 'b'] }).open(0);
    expect(play.action).toEqual(['a', 'b']);
    expect(remark).toMatch(/as recorded/);
  });
  it('takes the record of a guest, and of a mouse that cannot be run', async () => {
    expect((await setup({ record: ['g'] }).open(1)).play.action).toEqual(['g']);
    expect((await setup({ record: ['g'] }).open(0)).play.action).toEqual(['g']);
  });
  it('runs the oracle too', async () => expect((await setup({ run: ['o'] }).open(2)).play.action).toEqual(['o']));
  it('says what to do about a guest without a record, and about a maze that is missing', async () => {
    await expect(setup({}).open(1)).rejects.toThrow(/no record of program:x in a.*Drop its record/);
    await expect(setup({ run: ['a'], maze: false }).open(0)).rejects.toThrow(/maze a is not in this page/);
    await expect(setup({}).open(0)).rejects.toThrow(/cannot run it/);
  });
});

describe('the record of a contest', () => {
  const contest = (seed: number | null) => ({ seed }) as Contest;
  it('is found by its seed, or by its place where there are no seeds', () => {
    const seeded = [1, 2].map((seed) => ({ mouse: 'm', maze: 'a', seed }));
    expect(recordOf(seeded, contest(2), 0)?.seed).toBe(2);
    expect(recordOf(seeded, contest(3), 0)).toBeNull();
    const plain: PackedRecord[] = [
      { mouse: 'm', maze: 'a', n: 0 },
      { mouse: 'm', maze: 'a', n: 1 },
    ];
    expect(recordOf(plain, contest(2), 1)?.n).toBe(1);
    expect(recordOf(plain, contest(2), 5)).toBeNull();
  });
});
