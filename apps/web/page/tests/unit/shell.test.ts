import { describe, expect, it } from 'vitest';
import { CoreError } from '../../src/core/client';
import type { MazeData, Opened, Play, RaceResults } from '../../src/core/types';
import { linesOf, problemLine } from '../../src/shell/notices';
import { routeOf } from '../../src/link/routes';
import { summary } from '../../src/shell/files';
import { openIn, sortOut, type Open } from '../../src/shell/sorting-out';

describe('addresses', () => {
  it('name a view, with what it adds, or hold a maze', () => {
    expect(routeOf('#race')).toEqual({ view: 'race', more: false });
    expect(routeOf('#live&mouse=flood')).toEqual({ view: 'live', more: true });
    expect(routeOf('#maze=1.abc')).toEqual({ link: '1.abc' });
    expect(routeOf('#maze=')).toEqual({ link: '' });
    for (const odd of ['', '#', '#races', '#constructor', '#<img>']) expect(routeOf(odd)).toBeNull();
  });
});

describe('what went wrong', () => {
  it('is told with line and column, as the core has it', () => {
    expect(problemLine({ line: 3, column: 7, reason: 'r' })).toBe('line 3, column 7: r');
    expect(problemLine({ line: 3, column: 0, reason: 'r' })).toBe('line 3: r');
    expect(problemLine({ line: 0, column: 12, reason: 'r' })).toBe('byte 12: r');
    expect(problemLine({ line: 0, column: 0, reason: 'r' })).toBe('r');
  });
  it('is not told twice, nor by the thousand', () => {
    expect(linesOf(new CoreError('m', [{ line: 0, column: 0, reason: 'm' }]))).toEqual({ message: 'm', places: [] });
    const many = Array.from({ length: 1000 }, (_, i) => ({ line: i + 1, column: 1, reason: 'r' }));
    const { places } = linesOf(new CoreError('m', many));
    expect(places.length).toBeLessThan(20);
    expect(places.at(-1)).toMatch(/^and \d+ more$/);
    expect(linesOf('text')).toEqual({ message: 'text', places: [] });
  });
});

describe('dropped files', () => {
  const maze = (name: string) => ({ name }) as MazeData;
  /** Files are called by what they are; a "lost" record needs the maze "home". */
  const open: Open = async (file, given): Promise<Opened> => {
    if (file.name === 'home') return { kind: 'maze', maze: maze('home'), notes: ['it has a gap'] };
    if (file.name === 'other') return { kind: 'maze', maze: maze('other'), notes: [] };
    if (file.name === 'results') return { kind: 'results', results: {} as RaceResults };
    if (file.name === 'record' || (file.name === 'lost' && given?.name === 'home'))
      return { kind: 'record', play: { mouse: file.name } as Play };
    throw new Error(`${file.name} is nothing`);
  };
  const file = (name: string) => ({ name, bytes: new TextEncoder().encode(`text of ${name}`) });

  it('are sorted by what the core says of them', async () => {
    const sorted = await sortOut(['record', 'home', 'bad', 'results'].map(file), open);
    expect(sorted.mazes).toEqual([maze('home')]);
    expect(summary(sorted)).toContain('home: it has a gap.');
    expect(sorted.plays).toEqual([{ play: { mouse: 'record' }, record: 'text of record' }]);
    expect(sorted.results).toHaveLength(1);
    expect(sorted.refused.map(({ file: { name }, error }) => [name, String(error)])).toEqual([
      ['bad', 'Error: bad is nothing'],
    ]);
  });
  it('help each other: a record takes a maze that came with it', async () => {
    const sorted = await sortOut(['lost', 'other', 'home'].map(file), open);
    expect(sorted.refused).toEqual([]);
    expect(sorted.plays[0].play.mouse).toBe('lost');
  });
  it('find the maze that fits among those at hand, or none', async () => {
    expect((await openIn(file('lost'), [maze('other'), maze('home')], open))?.maze.name).toBe('home');
    expect(await openIn(file('lost'), [maze('other')], open)).toBeNull();
    expect(await openIn(file('results'), [maze('other')], open)).toBeNull();
  });
});

describe('what was opened', () => {
  const record = (ended: boolean) => ({
    play: { mouse: 'flood', ended, outcome: ended ? 'finished' : 'the record breaks off after step 3' } as Play,
    record: '',
  });
  const summaryOf = (...plays: ReturnType<typeof record>[]) =>
    summary({ mazes: [], notes: [], plays, results: [], robots: [], refused: [] });
  it('is told with the fact that a record breaks off, and where', () => {
    expect(summaryOf(record(true))).not.toContain('breaks off');
    expect(summaryOf(record(true), record(false))).toContain('flood: the record breaks off after step 3');
  });
});
