// One folder for the files of all tests, gone when they have ended.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { TestProject } from 'vitest/node';

declare module 'vitest' {
  interface ProvidedContext {
    folder: string;
  }
}

export default function start(project: TestProject) {
  const folder = mkdtempSync(join(tmpdir(), 'labmouse-'));
  project.provide('folder', folder);
  return () => rmSync(folder, { recursive: true, force: true });
}
