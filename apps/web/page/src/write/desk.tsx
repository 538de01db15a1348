// The editor with what belongs to it: the language, a name, programs to begin with, files and links.
import type { ComponentChildren } from 'preact';
import { Button, Select } from '../ui/controls';
import { Copyable } from '../ui/copy';
import { Field } from '../ui/field';
import { askForFiles } from '../ui/pick';
import type { Page } from '../page/page';
import { createEditor, type Editor } from './editor/editor';
import { linkOf, longestProgram, readLink, type Work } from './keeping';
import { languages } from './languages';
import { Reference } from './reference';
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
  /** Its name as it is typed, and what is wrong with it. */
  name: string;
  error: string;
}

const firstOf = (language: Language, name = usualName): Work => ({ language, name, text: language.templates[0].text });

/** Keeps what is written, and says so; `draw` is called where another tab did. */
function createKeeping(page: Page, draft: Draft, stored: Stored, draw: () => void) {
  let says = '';
  let isKept = false;
  stored.onOverwritten(() => {
    says = both;
    draw();
  });
  return {
    says: () => says,
    isKept: () => isKept,
    keep() {
      if (draft.foreign) return;
      const others = stored.others().length;
      isKept = page.shelf.keeps() && stored.keep(draft.work);
      if (!isKept) says = 'This browser keeps nothing: save it as a file.';
      else if (stored.others().length > others) says = both;
      else if (says !== both) says = 'Kept in this browser.';
    },
    /** Keeps what stood there, in case somebody wants it back; the program of a link is nobody's. */
    putAside(own: Work | null = draft.work) {
      const isTemplate = own?.language.templates.some(({ text }) => text === own.text);
      if (own && !draft.foreign && !isTemplate && page.shelf.keeps()) stored.keepBefore(own);
    },
  };
}

/** A program of a file; null where it is too long. */
async function programOf(file: File, work: Work): Promise<Work | null> {
  if (file.size > longestProgram) return null;
  const ending = file.name.split('.').at(-1);
  const language = languages.find(({ fileName }) => fileName.endsWith(`.${ending}`)) ?? work.language;
  return { ...work, language, text: await file.text() };
}

/** What stood here before, or the template with that number; null where there is none. */
function beginningOf({ work }: Draft, chosen: string): Work | null {
  if (chosen === before) return kept(before);
  const template = chosen === '' ? undefined : work.language.templates[Number(chosen)];
  return template ? { ...work, text: template.text } : null;
}

/** What is written, and all that puts another program there; `edited` hears of what is kept or goes. */
function createProgram(page: Page, changed: (allowed: boolean) => void, draw: () => void, edited: () => void) {
  const stored = createStored();
  const last = () => stored.load() ?? firstOf(languages[0]);
  const draft: Draft = { work: last(), name: last().name, foreign: false, editor: null, error: '' };
  const keeping = createKeeping(page, draft, stored, draw);
  function wrote() {
    edited();
    keeping.keep();
    draw();
  }
  /** Puts a program into the editor; `undoable` as a change of the one that stands there. */
  function put(work: Work, undoable = false, foreign = draft.foreign) {
    Object.assign(draft, { work, name: work.name, foreign, error: '' });
    if (undoable) draft.editor?.replace(work.text);
    else draft.editor?.set(work.text, work.language.id);
    edited();
    changed(false);
  }
  /** One that is the user's, and may run. */
  function take(work: Work, undoable = false) {
    put(work, undoable, false);
    wrote();
  }
  return {
    draft,
    keeping,
    stored,
    wrote,
    put,
    take,
    /** Another program to begin with: one of the templates, or one that was kept. */
    begin(chosen: string) {
      const other = stored.others().find(({ name }) => name === chosen);
      const work = other?.work ?? beginningOf(draft, chosen);
      if (!work) return;
      keeping.putAside();
      take(work, !draft.foreign && work.language === draft.work.language);
      if (other && keeping.isKept()) stored.forget(other);
      draft.editor?.focus();
    },
    speak: (language: Language) => take(stored.load(language.id) ?? firstOf(language, draft.work.name)),
    rename(name: string) {
      Object.assign(draft, { work: { ...draft.work, name: name.trim() }, name, error: '' });
      wrote();
    },
    /** Lets the program of a link run. */
    allow() {
      draft.foreign = false;
      keeping.putAside(kept(draft.work.language.id));
      wrote();
      changed(true);
    },
    /** From the program of a link back to one's own. */
    back: () => put(last(), false, false),
  };
}

/** The editor of that draft; `wrote` hears of each change by hand. */
async function startEditor(room: HTMLElement, draft: Draft, wrote: () => void) {
  const editor = await createEditor(room, 'The program', (text) => {
    draft.work = { ...draft.work, text };
    editor.fail(null);
    wrote();
  });
  draft.editor = editor;
  editor.set(draft.work.text, draft.work.language.id);
}

/**
 * `changed` hears when what is written is another program, and when somebody has allowed that of a link to run. `moment` is
 * what a link says beside the program, from its first `&` on; `draw` is called after each change.
 */
export function createDesk(
  page: Page,
  changed: (allowed: boolean) => void,
  moment: () => Promise<string>,
  draw: () => void,
) {
  /** A link to what is written, once somebody has shared it, and how often somebody did. */
  const link = { text: '', count: 0 };
  const program = createProgram(page, changed, draw, () => void (link.text = ''));
  const { draft, keeping, wrote, put, take } = program;
  let name: HTMLInputElement | null = null;
  const address = async () => `write=${await linkOf(draft.work)}${await moment()}`;
  async function open(file: File) {
    const work = await programOf(file, draft.work);
    if (!work) return page.complain(`${file.name} is too long for the program of a mouse.`);
    keeping.putAside();
    take(work);
  }
  return {
    page,
    link,
    program,
    /** Makes the editor in its room. */
    enter: (room: HTMLElement | null) => void (room && startEditor(room, draft, wrote).catch(page.complain)),
    enterName: (input: HTMLInputElement | null) => void (name = input),
    /** What is written, or null while it may not run. */
    work: () => (draft.foreign ? null : draft.work),
    /** Saves it as a file. */
    save: () => page.save(draft.work.language.fileName, draft.work.text),
    async share() {
      Object.assign(link, { text: `${location.href.split('#')[0]}#${await address()}`, count: link.count + 1 });
      draw();
    },
    /** The text behind `#` that leads to what is written. */
    address,
    /** Shows the program of a link, which runs only once somebody has allowed it; rejected in words where there is none. */
    async receive(text: string) {
      const work = await readLink(text);
      if (!work) throw new Error('This link does not contain a whole program. Copy the whole link again.');
      draft.foreign = true;
      put(work);
    },
    open,
    fail: (line: number | null) => draft.editor?.fail(line),
    /** Says at the name what is wrong with it; nothing where that is empty. */
    complain(message: string) {
      draft.error = message;
      draw();
      if (message) name?.focus();
    },
  };
}

const Warning = ({ program: { draft, allow, back } }: { program: Desk['program'] }) => (
  <div class="warning" role="alert" hidden={!draft.foreign}>
    <p>
      This program came with a link: somebody else wrote it. It can reach neither this page nor any network; still, read
      it before you let it run.
    </p>
    <div class="row">
      <Button label="Let it run" act={allow} />
      <Button label="Back to mine" act={back} />
    </div>
  </div>
);

/** Programs to begin with. */
function Programs({ program: { draft, stored, begin } }: { program: Desk['program'] }) {
  const { templates } = draft.work.language;
  const others = stored.others().filter(({ work }) => work.text !== draft.work.text);
  const options = [
    ['', 'Start with …'],
    ...templates.map(({ name }, index) => [index, name]),
    ...(kept(before) ? [[before, 'What stood here before']] : []),
    ...others.map(({ name, work }) => [name, `Also kept: ${work.name}, ${work.language.name}`]),
  ];
  return (
    <label>
      <span class="unseen">Program to begin with</span>
      <Select options={options} value="" choose={begin} />
    </label>
  );
}

/** The language, the name, programs to begin with, files and links. */
function Bar({ desk: { page, program, enterName, open, save, share } }: { desk: Desk }) {
  const { draft, speak, rename } = program;
  const accept = '.js,.py,.mjs,.txt';
  return (
    <div class="row bar">
      {languages.length > 1 && (
        <label>
          <span class="unseen">Language</span>
          <Select
            options={languages.map(({ id, name }) => [id, name])}
            value={draft.work.language.id}
            choose={(chosen) => speak(languages.find(({ id }) => id === chosen)!)}
          />
        </label>
      )}
      <Programs program={program} />
      <Button label="Open" act={() => askForFiles(([file]) => void open(file), { accept })} />
      <Button label="Save" act={save} />
      <Button label="Share" act={() => share().catch(page.complain)} />
      <Field label="Name of your mouse" error={draft.error}>
        <input
          type="text"
          spellcheck={false}
          autocomplete="off"
          maxLength={40}
          value={draft.name}
          ref={enterName}
          onInput={({ currentTarget }) => rename(currentTarget.value)}
        />
      </Field>
    </div>
  );
}

interface RoomProps {
  desk: Desk;
  /** Hears each key before the editor and the browser. */
  press(event: KeyboardEvent): void;
  /** Stands below the editor. */
  children: ComponentChildren;
}

export const DeskRoom = ({ desk, press, children }: RoomProps) => (
  <div class="desk-editor" onKeyDownCapture={press}>
    <Bar desk={desk} />
    <Warning program={desk.program} />
    {desk.link.text && <Copyable key={desk.link.count} label="A link to this program" text={desk.link.text} atOnce />}
    <div class="editor" key="editor" ref={desk.enter} />
    <p class="note">
      Ctrl+Enter runs, Ctrl+S saves; Escape, then Tab leads on. <span role="status">{desk.program.keeping.says()}</span>
    </p>
    {children}
    <details class="api">
      <summary>What it reads and answers</summary>
      <div>
        <Reference id={desk.program.draft.work.language.id} />
      </div>
    </details>
  </div>
);
