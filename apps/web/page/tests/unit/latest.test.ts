import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { createLatest } from '../../src/ui/latest';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** A `latest` whose answers are given by hand. */
function setUp() {
  const asked: string[] = [];
  const heard: string[] = [];
  const open: { resolve: (answer: string) => void; reject: (error: Error) => void }[] = [];
  const latest = createLatest<string, string>(
    (question) => {
      asked.push(question);
      return new Promise((resolve, reject) => open.push({ resolve, reject }));
    },
    (answer, question) => heard.push(`${question}: ${answer}`),
    (error, question) => heard.push(`${question} failed: ${(error as Error).message}`),
    100,
  );
  return { latest, asked, heard, open };
}

it('waits for a moment of rest', async () => {
  const { latest, asked } = setUp();
  latest.ask('a');
  await vi.advanceTimersByTimeAsync(60);
  latest.ask('b');
  await vi.advanceTimersByTimeAsync(60);
  expect(asked).toEqual([]);
  await vi.advanceTimersByTimeAsync(60);
  expect(asked).toEqual(['b']);
});

it('asks one question at a time and drops stale answers', async () => {
  const { latest, asked, heard, open } = setUp();
  latest.ask('a');
  await vi.advanceTimersByTimeAsync(100);
  latest.ask('b');
  await vi.advanceTimersByTimeAsync(100);
  latest.ask('c');
  await vi.advanceTimersByTimeAsync(100);
  expect(asked).toEqual(['a']);
  open[0].resolve('old');
  await vi.advanceTimersByTimeAsync(0);
  expect(asked).toEqual(['a', 'c']);
  open[1].resolve('new');
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toEqual(['c: new']);
});

it('tells of failures, unless they are stale', async () => {
  const { latest, heard, open } = setUp();
  latest.ask('a');
  await vi.advanceTimersByTimeAsync(100);
  latest.ask('b');
  open[0].reject(new Error('no'));
  await vi.advanceTimersByTimeAsync(100);
  open[1].reject(new Error('never'));
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toEqual(['b failed: never']);
});

it('is silent after a cancel', async () => {
  const { latest, asked, heard, open } = setUp();
  latest.ask('a');
  await vi.advanceTimersByTimeAsync(100);
  latest.ask('b');
  latest.cancel();
  open[0].resolve('late');
  await vi.advanceTimersByTimeAsync(200);
  expect([asked, heard]).toEqual([['a'], []]);
});
