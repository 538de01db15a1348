// A robot.py of the capstone project, played by MicroPython.
import dialogue from '../../../../../../labmouse/external/bridge/dialogue.py?raw';
import otherPython from '../../../../../../labmouse/external/bridge/other_python.py?raw';
import type { FromWorker } from '../runtime';
import { startInterpreter, type Interpreter } from './interpreter';
import page from './page.py?raw';
import { createPrinter } from './printer';

/** What MicroPython lacks of Python's library, by the name of its file. */
const shims = import.meta.glob<string>('./shims/*.py', { query: '?raw', import: 'default', eager: true });

interface Heard {
  said?: string | null;
  failed?: string;
  line?: number | null;
}

/** Waits for the host's lines, one at a time. */
export interface Robot {
  hear(line: string): void;
}

function prepare(python: Interpreter, program: string) {
  for (const [file, text] of Object.entries(shims)) python.write(file.replace('./', '/'), text);
  python.write('/robot/robot.py', program);
  python.run("import os, sys\nos.chdir('/robot')\nsys.path[:] = ['', '/shims', '.frozen']\nimport _beginning");
  python.run([dialogue, otherPython, page].join('\n'));
}

/** Of an error that MicroPython could not tell itself: too little memory, or too many calls. */
function crash(error: unknown): FromWorker {
  const text = error instanceof Error ? error.message : String(error);
  const line = [...text.matchAll(/File "robot\.py", line (\d+)/g)].at(-1);
  const message = error instanceof RangeError ? 'calls go too deep' : (text.trim().split('\n').at(-1) ?? '');
  return { kind: 'failed', message, line: line ? Number(line[1]) : null };
}

/** Reads the program; what it says goes to `post`. */
export async function startRobot(
  wasm: BufferSource,
  program: string,
  post: (message: FromWorker) => void,
): Promise<Robot> {
  const printer = createPrinter((text) => post({ kind: 'print', text }));
  const python = await startInterpreter(wasm, printer.put);
  prepare(python, program);
  let failed = false;

  function answer(line: string): FromWorker | null {
    try {
      const heard = JSON.parse(python.call('hear', line)) as Heard;
      if (heard.failed !== undefined) return { kind: 'failed', message: heard.failed, line: heard.line ?? null };
      return typeof heard.said === 'string' ? { kind: 'reply', lines: [heard.said] } : null;
    } catch (error) {
      return crash(error);
    }
  }
  return {
    hear(line) {
      if (failed) return;
      const message = answer(line);
      printer.flush();
      failed = message?.kind === 'failed';
      if (message) post(message);
    },
  };
}
