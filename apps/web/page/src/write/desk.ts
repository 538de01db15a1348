// The editor with what belongs to it: the language, a name, programs to begin with, files and links.
import { h } from '../ui/dom';
import { createCopyable } from '../ui/copy';
import { field } from '../ui/field';
import type { Page } from '../page/page';
import { createEditor, type Editor } from './editor/editor';
import { linkOf, longestProgram, readLink, type Work } from './keeping';
import { languages } from './languages';
import { reference } from './reference';
import { before, createStored, kept } from './stored';

export interface Desk {
  element: HTMLElement;
  /** What is written, or null while it may not run. */
  work(): Work | null;
  /** Saves it as a file. */
  save(): void;
  /** The text behind `#` that leads to what is written. */
  address(): Promise<string>;
  /** Shows the program of a link, which runs only once somebody has allowed it; rejected in words where there is none. */
  receive(link: string): Promise<void>;
  /** Shows the program of a file. */
  open(file: File): Promise<void>;
  fail(line: number | null): void;
  /** Says at the name what is wrong with it; nothing where that is empty. */
  complain(message: string): void;
}

const usualName = 'my-mouse';
const both = 'Another tab also wrote a program. Both are kept: “Start with …” has the other one.';

/**
 * `changed` hears when what is written is another program, and when somebody has allowed that of a link to run. `moment` is
 * what a link says beside the program, from its first `&` on; `below` stands below the editor.
 */
export function createDesk(
  page: Page,
  changed: (allowed: boolean) => void,
  moment: () => Promise<string>,
  below: HTMLElement,
): Desk {
  const stored = createStored();
  let isKept = false;
  let now: Work = stored.load() ?? { language: languages[0], name: usualName, text: languages[0].templates[0].text };
  let foreign = false;
  let editor: Editor | null = null;

  const language = h(
    'select',
    {},
    ...languages.map(({ id, name }) => h('option', { value: id, selected: id === now.language.id }, name)),
  );
  const name = h('input', { type: 'text', value: now.name, spellcheck: 'false', autocomplete: 'off', maxlength: 40 });
  const nameRow = field('Name of your mouse', name);
  const begin = h('select', {});
  const host = h('div', { class: 'editor' });
  const says = h('span', { role: 'status' });
  const warning = h(
    'div',
    { class: 'warning', role: 'alert', hidden: true },
    h(
      'p',
      {},
      'This program came with a link: somebody else wrote it. It can reach neither this page nor any network; still, read it before you let it run.',
    ),
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', onclick: allow }, 'Let it run'),
      h('button', { type: 'button', onclick: backToMine }, 'Back to mine'),
    ),
  );
  const link = createCopyable('A link to this program');
  link.element.hidden = true;
  const help = h('div', {});

  function offer() {
    const { templates } = now.language;
    const others = stored.others().filter(({ work }) => work.text !== now.text);
    begin.replaceChildren(
      h('option', { value: '' }, 'Start with …'),
      ...templates.map((one, index) => h('option', { value: index }, one.name)),
      ...(kept(before) ? [h('option', { value: before }, 'What stood here before')] : []),
      ...others.map(({ name, work }) => h('option', { value: name }, `Also kept: ${work.name}, ${work.language.name}`)),
    );
    help.replaceChildren(reference(now.language.id));
    language.value = now.language.id;
  }
  /** Puts a program into the editor; `undoable` as a change of the one that stands there. */
  function put(work: Work, undoable = false) {
    now = work;
    name.value = work.name;
    if (undoable) editor?.replace(work.text);
    else editor?.set(work.text, work.language.id);
    link.element.hidden = true;
    nameRow.complain('');
    offer();
    changed(false);
  }
  function wrote() {
    link.element.hidden = true;
    if (foreign) return;
    const others = stored.others().length;
    isKept = page.shelf.keeps() && stored.keep(now);
    if (!isKept) says.replaceChildren('This browser keeps nothing: save it as a file.');
    else if (stored.others().length > others) tellOfBoth();
    else if (says.textContent !== both) says.replaceChildren('Kept in this browser.');
  }
  function tellOfBoth() {
    says.replaceChildren(both);
    offer();
  }
  /** Keeps what stood there, in case somebody wants it back. */
  function putAside(own: Work | null = now) {
    const isTemplate = own?.language.templates.some(({ text }) => text === own.text);
    if (own && !isTemplate && page.shelf.keeps()) stored.keepBefore(own);
  }
  function allow() {
    foreign = false;
    warning.hidden = true;
    putAside(kept(now.language.id));
    wrote();
    offer();
    changed(true);
  }
  function backToMine() {
    foreign = false;
    warning.hidden = true;
    put(stored.load() ?? { language: languages[0], name: usualName, text: languages[0].templates[0].text });
  }
  begin.addEventListener('change', () => {
    const other = stored.others().find(({ name }) => name === begin.value);
    const back = other?.work ?? (begin.value === before ? kept(before) : null);
    const template = now.language.templates[Number(begin.value)];
    if (begin.value === '' || !(back ?? template)) return;
    if (!foreign) putAside();
    const next = back ?? { ...now, text: template.text };
    const undoable = !foreign && next.language === now.language;
    foreign = false;
    warning.hidden = true;
    put(next, undoable);
    wrote();
    if (other && isKept) stored.forget(other);
    editor?.focus();
  });
  language.addEventListener('change', () => {
    const chosen = languages.find(({ id }) => id === language.value)!;
    foreign = false;
    warning.hidden = true;
    put(stored.load(chosen.id) ?? { language: chosen, name: now.name, text: chosen.templates[0].text });
    wrote();
  });
  name.addEventListener('input', () => {
    now = { ...now, name: name.value.trim() };
    nameRow.complain('');
    wrote();
  });
  async function open(file: File) {
    if (file.size > longestProgram) return page.complain(`${file.name} is too long for the program of a mouse.`);
    const ending = file.name.split('.').at(-1);
    const of = languages.find(({ fileName }) => fileName.endsWith(`.${ending}`)) ?? now.language;
    if (!foreign) putAside();
    foreign = false;
    warning.hidden = true;
    put({ ...now, language: of, text: await file.text() });
    wrote();
  }
  function openFile() {
    const input = h('input', { type: 'file', accept: '.js,.py,.mjs,.txt' });
    input.onchange = () => input.files?.[0] && void open(input.files[0]);
    input.click();
  }
  const save = () => page.save(now.language.fileName, now.text);
  const address = async () => `write=${await linkOf(now)}${await moment()}`;
  async function share() {
    link.show(`${location.href.split('#')[0]}#${await address()}`);
    link.element.hidden = false;
    await link.copy();
  }
  const shared = () => share().catch(page.complain);
  stored.onOverwritten(tellOfBoth);
  const button = (label: string, onclick: () => unknown) =>
    h('button', { type: 'button', onclick: () => void onclick() }, label);
  offer();
  createEditor(host, 'The program', (text) => {
    now = { ...now, text };
    editor?.fail(null);
    wrote();
  }).then(
    (made) => {
      editor = made;
      made.set(now.text, now.language.id);
    },
    (error) => page.complain(error),
  );
  return {
    element: h(
      'div',
      { class: 'desk-editor' },
      h(
        'div',
        { class: 'row bar' },
        languages.length > 1 && h('label', {}, h('span', { class: 'unseen' }, 'Language'), language),
        h('label', {}, h('span', { class: 'unseen' }, 'Program to begin with'), begin),
        button('Open', openFile),
        button('Save', save),
        button('Share', shared),
        nameRow,
      ),
      warning,
      link.element,
      host,
      h('p', { class: 'note' }, 'Ctrl+Enter runs, Ctrl+S saves; Escape, then Tab leads on. ', says),
      below,
      h('details', { class: 'api' }, h('summary', {}, 'What it reads and answers'), help),
    ),
    work: () => (foreign ? null : now),
    save,
    address,
    async receive(text) {
      const work = await readLink(text);
      if (!work) throw new Error('This link does not contain a whole program. Copy the whole link again.');
      foreign = true;
      warning.hidden = false;
      put(work);
    },
    open,
    fail: (line) => editor?.fail(line),
    complain(message) {
      nameRow.complain(message);
      if (message) name.focus();
    },
  };
}
