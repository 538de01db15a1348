// The licences of the libraries inside of the page, which have to go with every copy of it.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const here = 'apps/web/page/build/notices.ts';
const package_ = /^(.*\/node_modules\/((?:@[^/]+\/)?[^/]+))\//;

/**
 * Libraries whose packages name a licence and bring no text of it: the text that stands for it here, and the version whose
 * package was looked at. Another one has to be looked at again.
 */
const withoutText: Record<string, { version: string; licence: string; file: string }> = {
  '@micropython/micropython-webassembly-pyscript': {
    version: '1.27.0',
    licence: 'MIT',
    file: fileURLToPath(new URL('../src/write/python/MICROPYTHON-LICENSE', import.meta.url)),
  },
};

/** What may stand in a comment of HTML. */
const inComment = (text: string) => text.trim().replaceAll('--', '- -');

/** The licences of what the core is made of besides our own: the compiler brings no texts that all systems have. */
export const coreLicences = (): string =>
  inComment(readFileSync(fileURLToPath(new URL('../src/core/LICENCES', import.meta.url)), 'utf8'));

/** The text of a library's licence, without what may not stand in a comment. */
export function licenceOf(folder: string, name: string): string {
  const file = readdirSync(folder).find((one) => /^(licen[sc]e|copying)/i.test(one));
  const ours = withoutText[name];
  if (file && ours) throw new Error(`${name} brings its licence by now: take ${ours.file} out`);
  if (!file && !ours) throw new Error(`${name} brings no text of its licence: look it up, and name it in ${here}`);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  if (ours && (version !== ours.version || license !== ours.licence))
    throw new Error(`${name} is ${version} under ${license}: compare ${ours.file} with it, and say so in ${here}`);
  return inComment(readFileSync(file ? join(folder, file) : ours.file, 'utf8'));
}

/** One comment of HTML for all libraries that these modules and the core are of; those with one text stand together. */
export function notices(modules: Iterable<string>): string {
  const folders = new Map<string, string>();
  for (const id of modules) {
    const [, folder, name] = package_.exec(id.replaceAll('\0', '')) ?? [];
    if (name) folders.set(name, folder);
  }
  const texts = new Map<string, string[]>();
  for (const [name, folder] of [...folders].sort()) {
    const text = licenceOf(folder, name);
    texts.set(text, [...(texts.get(text) ?? []), name]);
  }
  const parts = [...texts].map(([text, names]) => `${names.join(', ')}\n\n${text}`);
  return `<!-- This page contains libraries of others.\n\n${[...parts, coreLicences()].join('\n\n\n')}\n-->`;
}

/** What the page's own workers are made of, as they are built. */
export const workerModules = new Set<string>();

/** Notes the modules of a worker, which is a bundle of its own. */
export const noteModules = (): Plugin => ({
  name: 'labmouse-worker-modules',
  generateBundle(_, bundle) {
    for (const file of Object.values(bundle))
      if (file.type === 'chunk') for (const id of file.moduleIds) workerModules.add(id);
  },
});
