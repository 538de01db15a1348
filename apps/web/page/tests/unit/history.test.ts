import { expect, it } from 'vitest';
import { createHistory } from '../../src/draw/history';

it('goes back and forth', () => {
  const history = createHistory('a');
  expect([history.canUndo(), history.canRedo(), history.undo(), history.redo()]).toEqual([false, false, false, false]);
  history.add('b');
  history.add('c');
  expect(history.undo()).toBe(true);
  expect(history.now()).toBe('b');
  history.undo();
  expect([history.now(), history.canUndo(), history.canRedo()]).toEqual(['a', false, true]);
  history.redo();
  history.redo();
  expect([history.now(), history.redo()]).toEqual(['c', false]);
});

it('forgets what was undone when something else is drawn', () => {
  const history = createHistory('a');
  history.add('b');
  history.undo();
  history.add('c');
  expect([history.now(), history.canRedo()]).toEqual(['c', false]);
  history.undo();
  expect(history.now()).toBe('a');
});

it('takes no change for no step', () => {
  const history = createHistory('a');
  history.add('b');
  history.undo();
  history.add('a');
  expect([history.canUndo(), history.canRedo()]).toEqual([false, true]);
});

it('forgets the oldest steps where there are too many', () => {
  const history = createHistory(0, 3);
  for (let i = 1; i <= 10; ++i) history.add(i);
  let steps = 0;
  while (history.undo()) steps += 1;
  expect([steps, history.now()]).toEqual([3, 7]);
});
