// What was drawn, step by step, to go back and forth in.

export interface History<State> {
  now(): State;
  /** The next step; what was undone before is gone. A state that is the same object as now's is no step. */
  add(state: State): void;
  /** One step back or on; false where there is none. */
  undo(): boolean;
  redo(): boolean;
  canUndo(): boolean;
  canRedo(): boolean;
}

/** A history that forgets its oldest steps where there are more than `most`. */
export function createHistory<State>(first: State, most = 2000): History<State> {
  let states = [first];
  let at = 0;
  const canUndo = () => at > 0;
  const canRedo = () => at + 1 < states.length;
  return {
    now: () => states[at],
    add(state) {
      if (state === states[at]) return;
      states = [...states.slice(Math.max(0, at + 1 - most), at + 1), state];
      at = states.length - 1;
    },
    undo() {
      if (!canUndo()) return false;
      at -= 1;
      return true;
    },
    redo() {
      if (!canRedo()) return false;
      at += 1;
      return true;
    },
    canUndo,
    canRedo,
  };
}
