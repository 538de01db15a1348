// A file that the user picks.
import { h } from './dom';

/** A button that asks for a file and gives its name and content. */
export function filePicker(label: string, picked: (name: string, content: Uint8Array) => void): HTMLElement {
  const input = h('input', { type: 'file', hidden: true });
  input.addEventListener('change', async () => {
    const file = input.files?.[0];
    input.value = '';
    if (file) picked(file.name, new Uint8Array(await file.arrayBuffer()));
  });
  return h('span', h('button', { type: 'button', onclick: () => input.click() }, label), input);
}
