// The pieces of a race that was held in the page, one mouse each, as one race.
import type { RacedMouse, RaceResults } from '../core/types';
import { sorted } from './sorting';

/** All mice of those races in the same mazes, best first; null where there is no race. */
export function joined(pieces: RaceResults[], stopped: boolean): RaceResults | null {
  if (pieces.length === 0) return null;
  const mice = sorted(
    pieces.flatMap((piece) => piece.mice),
    (mouse: RacedMouse) => mouse.penalised_mean,
    'ascending',
  );
  // The notes speak of the race as a whole, so those of pieces cannot be put together.
  const notes = pieces.length === 1 ? pieces[0].notes : undefined;
  return { ...pieces[0], notes, stopped: stopped || pieces.some((piece) => piece.stopped), mice };
}
