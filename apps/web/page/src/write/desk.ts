// The editor with what belongs to it: the language, a name, programs to begin with, files and links.
import { button, select } from '../ui/controls';
import { createCopyable } from '../ui/copy';
import { h } from '../ui/dom';
import { field } from '../ui/field';
import type { Page } from '../page/page';
import { createEditor, type Editor } from './editor/editor';
import { linkOf, longestProgram, readLink, type Work } from './keeping';
import { languages } from './languages';
import { reference } from './reference';
import type { Language } from './runtime';
import { before, createStored, kept, type Stored } from './stored';

export type Desk = ReturnType<typeof createDesk>;

const usualName = 'my-mouse';
const both = 'Another tab also wrote a program. Both are kept: “Start with …” has the other one.';

/** What stands in the editor. */
interface Draft {
  work: Work;
  /** It came with a link, and nobody has allowed it to run. */
  foreign: boolean;
  /** Null until it has been loaded. */
  editor: Editor | null;
}

const firstOf = (language: Language, name = usualName): Work => ({ language, name, text: language.templates[0].text });

/** Keeps what is written, and says so; `offer` is called where another program is kept, too. */
function createKeeping(page: Page, draft: Draft, stored: Stored, offer: () => void) {
  const says = h('span', { role: 'status' });
  let isKept = false;
  function tellOfBoth() {
    says.replaceChildren(both);
    offer();
  }
  stored.onOverwritten(tellOfBoth);
  return {
    says,
    isKept: () => isKept,
    keep() {
      if (draft.foreign) return;
      const others = stored.others().length;
      isKept = page.shelf.keeps() && stored.keep(draft.work);
      if (!isKept) says.replaceChildren('This browser keeps nothing: save it as a file.');
      else if (stored.others().length > others) tellOfBoth();
      else if (says.textContent !== both) says.replaceChildren('Kept in this browser.');
    },
    /** Keeps what stood there, in case somebody wants it back. */
    putAside(own: Work | null = draft.work) {
      const isTemplate = own?.language.templates.some(({ text }) => text === own.text);
      if (own && !isTemplate && page.shelf.keeps()) stored.keepBefore(own);
    },
  };
}

const createWarning = (allow: () => void, back: () => void) =>
  h(
    'div.warning',
    { role: 'alert', hidden: true },
    h(
      'p',
      'This program came with a link: somebody else wrote it. It can reach neither this page nor any network; still, read it before you let it run.',
    ),
    h('div.row', button('Let it run', allow), button('Back to mine', back)),
  );

interface Choices {
  /** Another program to begin with: one of the templates, or one that was kept, then with what it is to be forgotten as. */
  begin(work: Work, kept?: () => void): void;
  speak(language: Language): void;
  rename(name: string): void;
}

/** The language, the name, and programs to begin with. */
function createHead(draft: Draft, stored: Stored, { begin, speak, rename }: Choices) {
  const language = select(
    languages.map(({ id, name }) => [id, name]),
    (chosen) => speak(languages.find(({ id }) => id === chosen)!),
  );
  const name = h('input', {
    type: 'text',
    value: draft.work.name,
    spellcheck: 'false',
    autocomplete: 'off',
    maxlength: 40,
    oninput: () => rename(name.value.trim()),
  });
  const others = () => stored.others().filter(({ work }) => work.text !== draft.work.text);
  const programs = select([], (chosen) => {
    const other = stored.others().find(({ name }) => name === chosen);
    const template = draft.work.language.templates[Number(chosen)];
    const back = other?.work ?? (chosen === before ? kept(before) : null);
    if (chosen === '' || !(back ?? template)) return;
    begin(back ?? { ...draft.work, text: template.text }, other && (() => stored.forget(other)));
  });
  const help = h('div');
  function offer() {
    const { language: spoken } = draft.work;
    programs.replaceChildren(
      h('option', { value: '' }, 'Start with …'),
      ...spoken.templates.map((one, index) => h('option', { value: index }, one.name)),
      ...(kept(before) ? [h('option', { value: before }, 'What stood here before')] : []),
      ...others().map(({ name, work }) =>
        h('option', { value: name }, `Also kept: ${work.name}, ${work.language.name}`),
      ),
    );
    help.replaceChildren(reference(spoken.id));
    language.value = spoken.id;
  }
  return { language, name, nameRow: field('Name of your mouse', name), programs, help, offer };
}

/** A program of a file; null where it is too long. */
async function programOf(file: File, work: Work): Promise<Work | null> {
  if (file.size > longestProgram) return null;
  const ending = file.name.split('.').at(-1);
  const language = languages.find(({ fileName }) => fileName.endsWith(`.${ending}`)) ?? work.language;
  return { ...work, language, text: await file.text() };
}

function askForFile(open: (file: File) => void) {
  const input = h('input', { type: 'file', accept: '.js,.py,.mjs,.txt' });
  input.onchange = () => input.files?.[0] && open(input.files[0]);
  input.click();
}

/** What is written, and all that puts another program there; `edited` hears of what is kept or goes. */
function createProgram(page: Page, changed: (allowed: boolean) => void, edited: () => void) {
  const stored = createStored();
  const draft: Draft = { work: stored.load() ?? firstOf(languages[0]), foreign: false, editor: null };
  const keeping = createKeeping(page, draft, stored, () => head.offer());
  const warning = createWarning(allow, () => {
    own();
    put(stored.load() ?? firstOf(languages[0]));
  });
  const head = createHead(draft, stored, {
    begin(work, forget) {
      if (!draft.foreign) keeping.putAside();
      take(work, !draft.foreign && work.language === draft.work.language);
      if (keeping.isKept()) forget?.();
      draft.editor?.focus();
    },
    speak: (language) => take(stored.load(language.id) ?? firstOf(language, draft.work.name)),
    rename(name) {
      draft.work = { ...draft.work, name };
      head.nameRow.complain('');
      wrote();
    },
  });
  function wrote() {
    edited();
    keeping.keep();
  }
  /** It is the user's, and may run. */
  function own() {
    draft.foreign = false;
    warning.hidden = true;
  }
  /** Puts a program into the editor; `undoable` as a change of the one that stands there. */
  function put(work: Work, undoable = false) {
    draft.work = work;
    head.name.value = work.name;
    if (undoable) draft.editor?.replace(work.text);
    else draft.editor?.set(work.text, work.language.id);
    edited();
    head.nameRow.complain('');
    head.offer();
    changed(false);
  }
  function take(work: Work, undoable = false) {
    own();
    put(work, undoable);
    wrote();
  }
  function allow() {
    own();
    keeping.putAside(kept(draft.work.language.id));
    wrote();
    head.offer();
    changed(true);
  }
  head.offer();
  return { draft, keeping, warning, head, wrote, put, take };
}

/** A link to what `address` leads to, hidden until somebody shares it. */
function createLink(address: () => Promise<string>) {
  const { element, show, copy } = createCopyable('A link to this program');
  element.hidden = true;
  async function share() {
    show(`${location.href.split('#')[0]}#${await address()}`);
    element.hidden = false;
    await copy();
  }
  return { element, address, share, hide: () => void (element.hidden = true) };
}

const unseen = (label: string, control: HTMLElement) => h('label', h('span.unseen', label), control);

/**
 * `changed` hears when what is written is another program, and when somebody has allowed that of a link to run. `moment` is
 * what a link says beside the program, from its first `&` on; `below` stands below the editor.
 */
export function createDesk(
  page: Page,
  changed: (allowed: boolean) => void,
  moment: () => Promise<string>,
  below: HTMLElement,
) {
  const link = createLink(async () => `write=${await linkOf(draft.work)}${await moment()}`);
  const { draft, keeping, warning, head, wrote, put, take } = createProgram(page, changed, link.hide);
  const host = h('div.editor');
  createEditor(host, 'The program', (text) => {
    draft.work = { ...draft.work, text };
    draft.editor?.fail(null);
    wrote();
  }).then((made) => {
    draft.editor = made;
    made.set(draft.work.text, draft.work.language.id);
  }, page.complain);
  async function open(file: File) {
    const work = await programOf(file, draft.work);
    if (!work) return page.complain(`${file.name} is too long for the program of a mouse.`);
    if (!draft.foreign) keeping.putAside();
    take(work);
  }
  const save = () => page.save(draft.work.language.fileName, draft.work.text);
  const bar = h(
    'div.row.bar',
    languages.length > 1 && unseen('Language', head.language),
    unseen('Program to begin with', head.programs),
    button('Open', () => askForFile((file) => void open(file))),
    button('Save', save),
    button('Share', () => link.share().catch(page.complain)),
    head.nameRow,
  );
  const api = h('details.api', h('summary', 'What it reads and answers'), head.help);
  const note = h('p.note', 'Ctrl+Enter runs, Ctrl+S saves; Escape, then Tab leads on. ', keeping.says);
  return {
    element: h('div.desk-editor', bar, warning, link.element, host, note, below, api),
    /** What is written, or null while it may not run. */
    work: () => (draft.foreign ? null : draft.work),
    /** Saves it as a file. */
    save,
    /** The text behind `#` that leads to what is written. */
    address: link.address,
    /** Shows the program of a link, which runs only once somebody has allowed it; rejected in words where there is none. */
    async receive(text: string) {
      const work = await readLink(text);
      if (!work) throw new Error('This link does not contain a whole program. Copy the whole link again.');
      draft.foreign = true;
      warning.hidden = false;
      put(work);
    },
    open,
    fail: (line: number | null) => draft.editor?.fail(line),
    /** Says at the name what is wrong with it; nothing where that is empty. */
    complain(message: string) {
      head.nameRow.complain(message);
      if (message) head.name.focus();
    },
  };
}
