import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { core } from './build/core';
import { editor, editorScript } from './build/editor';
import { frame, frameScript } from './build/frame';
import { noteModules } from './build/notices';
import { oneFile } from './build/one-file';
import { micropython, python } from './build/python';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const wasm = process.env.LABMOUSE_CORE ?? `${root}build/web/labmouse_core.wasm`;

export default defineConfig({
  plugins: [
    core(wasm),
    editor(),
    frame(),
    micropython(),
    python(),
    oneFile('labmouse.html', async () => [await editorScript(), { script: frameScript(), modules: [] }]),
  ],
  worker: { format: 'iife', plugins: () => [core(wasm), noteModules()], rollupOptions: { treeshake: false } },
  // The tests read what the page shares with the program.
  server: { fs: { allow: [root] } },
  build: {
    target: 'es2022',
    outDir: process.env.LABMOUSE_PAGE ?? `${root}build/page`,
    emptyOutDir: false,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    // All of our code is used. Rollup 4.52 and 4.67 take calls out of it that they wrongly hold for calls without effect.
    rollupOptions: { treeshake: false },
  },
  test: {
    fileParallelism: false,
    projects: [
      // Patience with a busy machine: a look at the core takes a second on an idle one.
      { extends: true, test: { name: 'unit', include: ['tests/unit/**/*.test.{ts,tsx}'], testTimeout: 60_000 } },
      {
        extends: true,
        test: {
          name: 'end-to-end',
          include: ['tests/end-to-end/**/*.test.ts'],
          globalSetup: 'tests/end-to-end/folder.ts',
          setupFiles: 'tests/end-to-end/setup.ts',
          isolate: false,
          testTimeout: 150_000,
          // Patience with a busy machine: a second try, and long looks.
          retry: 1,
          expect: { poll: { timeout: 45_000 } },
          hookTimeout: 60_000,
        },
      },
      {
        extends: true,
        test: {
          name: 'firefox',
          include: ['tests/firefox/**/*.test.ts'],
          globalSetup: 'tests/end-to-end/folder.ts',
          testTimeout: 180_000,
          retry: 1,
          expect: { poll: { timeout: 15_000 } },
          hookTimeout: 60_000,
        },
      },
      {
        extends: true,
        test: {
          name: 'speed',
          include: ['bench/**/*.speed.ts'],
          globalSetup: 'tests/end-to-end/folder.ts',
          setupFiles: 'tests/end-to-end/setup.ts',
          testTimeout: 120_000,
        },
      },
      { extends: true, test: { name: 'pictures', include: ['bench/**/*.pictures.ts'] } },
    ],
  },
});
