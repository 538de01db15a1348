// What somebody wrote, as JSON and in links. What comes back from either may be anything.
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

export const jsonOf = ({ language, name, text }: Work) => JSON.stringify({ language: language.id, name, text });

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
