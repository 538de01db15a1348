// What somebody wrote: kept in the browser, and in links. What comes back from either may be anything.
import { besides as key } from '../shell/shelf';
import { languages } from './languages';
import type { Language } from './runtime';

export interface Work {
  language: Language;
  name: string;
  text: string;
}

/** No program of a mouse is longer, in letters. */
export const longestProgram = 500_000;

/** The work of that JSON; null where it is none. */
export function readWork(json: string): Work | null {
  try {
    const { language: id, name, text } = JSON.parse(json) as Record<string, unknown>;
    const language = languages.find((one) => one.id === id);
    if (!language || typeof name !== 'string' || typeof text !== 'string' || text.length > longestProgram) return null;
    return { language, name: name.slice(0, 100), text };
  } catch {
    return null;
  }
}

const jsonOf = ({ language, name, text }: Work) => JSON.stringify({ language: language.id, name, text });

/** Each language keeps its own, and the page the one that was written last. */
export function kept(id?: string): Work | null {
  try {
    return readWork(localStorage.getItem(id ? `${key}-${id}` : key) ?? '');
  } catch {
    return null;
  }
}

/** Whether it could be kept; a page from a disk may have no storage. */
export function keep(work: Work): boolean {
  try {
    localStorage.setItem(key, jsonOf(work));
    localStorage.setItem(`${key}-${work.language.id}`, jsonOf(work));
    return true;
  } catch {
    return false;
  }
}

/** Keeps it under a name of its own, beside what is being written. */
export function keepAside(work: Work, name: string) {
  try {
    localStorage.setItem(`${key}-${name}`, jsonOf(work));
  } catch {
    // Then it is gone, as all is that such a browser holds.
  }
}

const piped = async (bytes: Uint8Array<ArrayBuffer>, through: TransformStream<BufferSource, Uint8Array<ArrayBuffer>>) =>
  new Response(new Blob([bytes]).stream().pipeThrough(through));

/** The work as a text for links: letters, digits, - and _. */
export async function linkOf(work: Work): Promise<string> {
  const packed = await piped(new TextEncoder().encode(jsonOf(work)), new CompressionStream('deflate-raw'));
  const bytes = new Uint8Array(await packed.arrayBuffer());
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** The work of a link; null where it is none. A link that unpacks to more than any program is read no further. */
export async function readLink(link: string): Promise<Work | null> {
  try {
    const packed = Uint8Array.from(atob(link.replaceAll('-', '+').replaceAll('_', '/')), (sign) => sign.charCodeAt(0));
    const reader = (await piped(packed, new DecompressionStream('deflate-raw'))).body!.getReader();
    const decoder = new TextDecoder();
    let json = '';
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
      json += decoder.decode(next.value, { stream: true });
      if (json.length > 4 * longestProgram) return null;
    }
    return readWork(json + decoder.decode());
  } catch {
    return null;
  }
}
