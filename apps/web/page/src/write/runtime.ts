// What a language is in which mice are written in the page, and the words between the page and the worker in which such a
// program runs.

export type LanguageId = 'javascript' | 'python';

/** A program to begin with. */
export interface Template {
  name: string;
  text: string;
}

export interface Language {
  id: LanguageId;
  /** For people: "JavaScript". */
  name: string;
  /** Of a program that is saved: "mouse.js". */
  fileName: string;
  /** The SPEC under which the same file races on the command line: "program:node mouse.js". */
  commandLine: string;
  /** At least one; the first is what an editor begins with. */
  templates: Template[];
  /**
   * The script of the worker that runs a program. It stands in a sandboxed frame: it has no network, no storage and no
   * `eval`. A language whose programs are scripts puts the program into it; all others have it from `start`.
   */
  workerSource(program: string): Promise<string>;
  /** How many lines of that script stand before the program; 0 where the program is not in it. */
  linesBefore: number;
  /** Whether that script compiles WebAssembly, which its frame must allow then. */
  usesWasm: boolean;
}

/** To the worker. A line is one of the line protocol (docs/reference/protocols.md), without its end. */
export type ToWorker = { kind: 'start'; program: string } | { kind: 'hear'; line: string };

/** From the worker. Errors that it does not catch are failures, too. */
export type FromWorker =
  /** The program has been read and waits for lines. Sent once, after `start`. */
  | { kind: 'ready' }
  /** Lines of its standard output, whole ones without their ends; and what it wrote of the next one. */
  | { kind: 'reply'; lines: string[]; rest?: string }
  /** What it printed for its author, with all line ends: its standard error, or whatever is not of the protocol. */
  | { kind: 'print'; text: string }
  /** It failed, with the line of the program from 1, where that is known. Nothing follows. */
  | { kind: 'failed'; message: string; line: number | null }
  /** It ended itself. Nothing follows. */
  | { kind: 'exited'; code: number };
