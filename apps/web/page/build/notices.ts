// The licences of the libraries inside of the page, which have to go with every copy of it.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const package_ = /^(.*\/node_modules\/((?:@[^/]+\/)?[^/]+))\//;

/** The text of a library's licence, without what may not stand in a comment. */
function licenceOf(folder: string, name: string): string {
  const file = existsSync(folder) && readdirSync(folder).find((one) => /^licen[sc]e/i.test(one));
  if (file) return readFileSync(join(folder, file), 'utf8').trim().replaceAll('--', '- -');
  const { license, author } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  if (!license) throw new Error(`the library ${name} has no licence`);
  return `Licence: ${license}. ${typeof author === 'string' ? author : (author?.name ?? '')}`.trim();
}

/** One comment of HTML for all libraries that these modules are of; those with one text stand together. */
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
  return parts.length > 0 ? `<!-- This page contains libraries of others.\n\n${parts.join('\n\n\n')}\n-->` : '';
}
