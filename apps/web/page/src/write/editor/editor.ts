// The editor as the page sees it. It stands in a shadow root, where its style sheets need no place in the page's policy.
import packed from 'virtual:editor';
import { unpack } from '../../core/unpack';

export type EditorLanguage = 'javascript' | 'python';

export interface Editor {
  text(): string;
  /** Another text, with nothing to undo. */
  set(text: string, language: EditorLanguage): void;
  /** Another text in the same language, as one change that can be undone. */
  replace(text: string): void;
  /** Marks the line, from 1, in which the program failed, and shows it; null marks none. */
  fail(line: number | null): void;
  focus(): void;
}

type Create = (parent: ShadowRoot, label: string, changed: (text: string) => void) => Editor;

let created: Promise<Create> | null = null;

/** Puts the script of the editor into the page, whose policy has its hash. */
async function load(): Promise<Create> {
  const script = document.createElement('script');
  // Ahead of all modules, so that it has run when it stands there.
  script.textContent = new TextDecoder().decode(await unpack(packed));
  document.head.append(script);
  const { labmouseEditor } = globalThis as unknown as { labmouseEditor?: { create: Create } };
  if (!labmouseEditor) throw new Error('the editor could not be started');
  return labmouseEditor.create;
}

/** An editor inside of `host`; `changed` hears of each change by hand. */
export async function createEditor(host: HTMLElement, label: string, changed: (text: string) => void): Promise<Editor> {
  const create = await (created ??= load());
  return create(host.attachShadow({ mode: 'open' }), label, changed);
}
