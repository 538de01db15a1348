// A text to be copied: a button, and the text itself for where there is no clipboard.
import { h } from './dom';

export function createCopyable(label: string, button = 'Copy') {
  const text = h('input', { type: 'text', readonly: true, 'aria-label': label, spellcheck: 'false' });
  const said = h('span.copied', { role: 'status' });
  async function copy() {
    try {
      await navigator.clipboard.writeText(text.value);
      said.replaceChildren('copied');
    } catch {
      text.focus();
      text.select();
      said.replaceChildren('selected: copy it from the field');
    }
  }
  return {
    element: h('div.copyable', text, h('button', { type: 'button', onclick: copy }, button), said),
    show(value: string) {
      if (text.value === value) return;
      text.value = value;
      said.replaceChildren();
    },
    /** Copies what is shown; where the browser does not let it, the text is selected. */
    copy,
  };
}
