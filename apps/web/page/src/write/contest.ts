// A contest of a program that runs in the page: lines from the core to the program and back.
import type { Core } from '../core/client';
import type { MazeData, PackedRecord, Play, ProgramEnd, ProgramLines } from '../core/types';
import type { Language } from './runtime';
import type { Cage, Said, Session } from './sandbox/cage';
import { createPatience } from './sandbox/patience';

/** Milliseconds that a program may take to begin, and for one answer. */
export const patience = { start: 10_000, answer: 2000 };

/** So many letters of what a program prints are kept for its author. */
const mostPrinted = 200_000;

/** What the program printed while the contest stood at that frame. */
export interface Print {
  frame: number;
  text: string;
}

export interface ContestOutput {
  play: Play;
  record: string;
  packed: PackedRecord;
  started: boolean;
  microseconds: number;
  prints: Print[];
  /** How the program ended that should not have; null where it did not. */
  ended: ProgramEnd | null;
}

export interface Entry {
  language: Language;
  program: string;
  /** May be empty. */
  name: string;
  maze: MazeData;
  seed: number;
  /** Whether that is the seed of a race. */
  races?: boolean;
}

/** Text that is no Unicode cannot be passed to the core. */
const wellFormed = (text: string) => text.replace(/\p{Surrogate}/gu, '\ufffd');

/** How a program ended, by what it said last; null where it did not. */
function endOf(said: Said | null, silence: number): ProgramEnd | null {
  if (said === null) return { kind: 'silent', seconds: silence / 1000 };
  if (said.kind === 'flooded') return { kind: 'printed', what: 'more than 5000 pieces or a million letters' };
  if (said.kind === 'exited') return { kind: 'exited', code: said.code };
  if (said.kind !== 'failed') return null;
  const message = wellFormed(said.message).replace(/^Uncaught /, '');
  return { kind: 'failed', message: message.slice(0, 2000), ...(said.line !== null && { line: said.line }) };
}

/** The talk of one contest, until it has ended or nobody wants it any more. */
async function talk(
  core: Core,
  session: Session,
  entry: Entry,
  first: ProgramLines,
  kept: Kept,
  wanted: () => boolean,
) {
  let now = first;
  let printed = '';
  let rest = '';
  let limit = patience.start;
  let left = createPatience(limit);
  session.say({ kind: 'start', program: entry.program });
  const tell = (lines: string[]) => {
    for (const line of lines) session.say({ kind: 'hear', line });
    left = createPatience(limit);
  };
  while (!now.ended && wanted()) {
    // What it prints in the meantime is no answer.
    const said = await session.next(left);
    if (!wanted()) return;
    if (said?.kind === 'ready') {
      limit = patience.answer;
      tell(now.lines);
    } else if (said?.kind === 'print') {
      printed += said.text;
      kept.print(now.steps, said.text);
    } else if (said?.kind === 'reply') {
      rest = said.rest ?? '';
      if (said.lines.length === 0) continue;
      const output = wellFormed(`${said.lines.join('\n')}\n`);
      now = await core.call('program_hear', { contest: now.contest, output, printed: wellFormed(printed) });
      printed = '';
      tell(now.lines);
    }
    const end = endOf(said, limit);
    if (!end) continue;
    kept.ended = end;
    const last = { output: wellFormed(rest), printed: wellFormed(printed), end };
    now = await core.call('program_hear', { contest: now.contest, ...last });
  }
}

class Kept {
  prints: Print[] = [];
  ended: ProgramEnd | null = null;
  #room = mostPrinted;
  print(frame: number, text: string) {
    const last = this.prints.at(-1);
    const piece = text.length > this.#room ? `${text.slice(0, this.#room)}\n… (no more of it is kept)\n` : text;
    if (this.#room <= 0) return;
    this.#room -= text.length;
    if (last?.frame === frame) last.text += piece;
    else this.prints.push({ frame, text: piece });
  }
}

/** Runs the contest to its end; null where it was no longer wanted. Whatever the program does is part of the contest. */
export async function holdContest(
  core: Core,
  cage: Cage,
  entry: Entry,
  wanted: () => boolean = () => true,
): Promise<ContestOutput | null> {
  const { language, name, maze, seed, races = false } = entry;
  const first = await core.call('program_begin', { name, spec: language.commandLine, maze, seed, races });
  const kept = new Kept();
  const session = await cage.start(language, entry.program);
  try {
    await talk(core, session, entry, first, kept, wanted);
  } finally {
    session.end();
  }
  const held = await core.call('program_end', { contest: first.contest });
  return wanted() ? { ...held, prints: kept.prints, ended: kept.ended } : null;
}
