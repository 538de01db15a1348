// What came of a contest of one's program, in words.
import type { Play } from '../core/types';
import { isSameMaze } from '../maze/same';
import { patience, type ContestOutput } from './contest';

/** The line of the program in which it failed; null where it did not, or nobody knows. */
export const failedAt = ({ ended }: ContestOutput) => (ended?.kind === 'failed' && ended.line) || null;

/** Why a contest was a forfeit; empty where nobody knows. */
function whyInWords({ play, ended, started }: ContestOutput): string {
  const [said] = play.last_words.split('\n');
  if (ended?.kind === 'silent' && !started)
    return `it did not begin within ${patience.start / 1000} s; is there a loop without an end outside of its steps?`;
  if (ended?.kind === 'failed')
    return `error${ended.line ? ` in line ${ended.line}` : ''}: ${ended.message.split('\n')[0]}`;
  if (ended?.kind === 'silent') return said.replace(/; does it flush.*/, '; is there a loop without an end?');
  return said;
}

/** What came of a contest, in a line, and of the one before it; of a program that did not begin, wherever it was. */
export function outcomeInWords(held: ContestOutput, before?: Play): string {
  const { play } = held;
  if (!held.started) return `${play.mouse} did not start: ${whyInWords(held) || play.outcome}`;
  const where = `${play.mouse} in ${play.maze.name || 'this maze'}`;
  if (play.finished) {
    const was = before?.finished && before.score !== play.score && isSameMaze(before, play);
    const scores = `score ${play.score?.toFixed(3)}${was ? `, before ${before.score?.toFixed(3)}` : ''}`;
    return `${where}: finished, ${scores}; best possible ${play.bound?.toFixed(3) ?? 'none'}, lower is better`;
  }
  const why = whyInWords(held);
  return `${where}: ${play.outcome}${play.outcome.startsWith('forfeit') && why ? `; ${why}` : ''}`;
}
