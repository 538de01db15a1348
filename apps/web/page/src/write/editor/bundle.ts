// The editor: CodeMirror with what a page of program needs, as a script of its own (build/editor.ts).
import { defaultKeymap, history, historyKeymap, indentLess, insertTab, isolateHistory } from '@codemirror/commands';
import {
  bracketMatching,
  HighlightStyle,
  indentOnInput,
  indentUnit,
  StreamLanguage,
  syntaxHighlighting,
} from '@codemirror/language';
import { javascript } from '@codemirror/legacy-modes/mode/javascript';
import { python } from '@codemirror/legacy-modes/mode/python';
import { Compartment, EditorState, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration,
  drawSelection,
  EditorView,
  highlightActiveLine,
  keymap,
  lineNumbers,
  type DecorationSet,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';
import type { Editor, EditorLanguage } from './editor';

const languages = { javascript: StreamLanguage.define(javascript), python: StreamLanguage.define(python) };
const indents = { javascript: '  ', python: '    ' };

// Tones of the page, which are there inside of the editor, too.
const highlight = HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.definitionKeyword], color: 'var(--code-word)' },
  { tag: [tags.string, tags.special(tags.string)], color: 'var(--code-text)' },
  { tag: [tags.number, tags.bool, tags.null, tags.atom], color: 'var(--code-number)' },
  { tag: tags.comment, color: 'var(--muted)', fontStyle: 'italic' },
]);

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--paper)' },
  '&.cm-focused': { outline: '2px solid var(--focus)', outlineOffset: '-2px' },
  '.cm-scroller': {
    fontFamily: "ui-monospace, 'DejaVu Sans Mono', monospace",
    fontSize: 'var(--less)',
    lineHeight: '1.45',
    overflow: 'auto',
  },
  '.cm-content': { caretColor: 'var(--ink)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '.cm-gutters': { backgroundColor: 'var(--panel)', color: 'var(--muted)', border: '0' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--ink) 6%, transparent)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'color-mix(in srgb, var(--focus) 30%, transparent)',
  },
  '&.cm-focused .cm-matchingBracket': { backgroundColor: 'color-mix(in srgb, var(--focus) 30%, transparent)' },
  '.cm-failed': {
    backgroundColor: 'color-mix(in srgb, var(--wrong) 18%, transparent)',
    boxShadow: 'inset 4px 0 var(--wrong)',
  },
});

const setFailed = StateEffect.define<number | null>();
const failedLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, change) {
    marks = marks.map(change.changes);
    for (const effect of change.effects) {
      if (!effect.is(setFailed)) continue;
      const line = effect.value === null ? null : change.state.doc.line(Math.min(effect.value, change.state.doc.lines));
      marks = line ? Decoration.set([Decoration.line({ class: 'cm-failed' }).range(line.from)]) : Decoration.none;
    }
    return marks;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Where the keyboard is inside of the editor, Tab indents; after Escape it leads out. */
export function create(parent: ShadowRoot, label: string, changed: (text: string) => void): Editor {
  const language = new Compartment();
  const state = (text: string, name: EditorLanguage) =>
    EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        indentOnInput(),
        bracketMatching(),
        syntaxHighlighting(highlight),
        failedLine,
        theme,
        keymap.of([{ key: 'Tab', run: insertTab, shift: indentLess }, ...defaultKeymap, ...historyKeymap]),
        language.of([languages[name], indentUnit.of(indents[name])]),
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({
          'aria-label': label,
          tabindex: '0',
          autocapitalize: 'off',
          spellcheck: 'false',
        }),
        EditorView.updateListener.of((update) => update.docChanged && changed(update.state.doc.toString())),
      ],
    });
  const view = new EditorView({ state: state('', 'javascript'), parent, root: parent });
  return {
    text: () => view.state.doc.toString(),
    set(text, name) {
      view.setState(state(text, name));
      view.scrollDOM.scrollTop = 0;
    },
    replace(text) {
      const whole = { from: 0, to: view.state.doc.length, insert: text };
      view.dispatch({ changes: whole, selection: { anchor: 0 }, annotations: isolateHistory.of('full') });
      view.scrollDOM.scrollTop = 0;
    },
    fail(line) {
      const effects: StateEffect<unknown>[] = [setFailed.of(line)];
      if (line !== null) {
        const { from } = view.state.doc.line(Math.min(line, view.state.doc.lines));
        effects.push(EditorView.scrollIntoView(from, { y: 'center' }));
      }
      view.dispatch({ effects });
    },
    focus: () => view.focus(),
  };
}
