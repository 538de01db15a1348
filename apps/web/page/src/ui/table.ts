// Tables of which nothing changes.
import { h, type Attributes, type Child } from './dom';

/** A place for what may be wider than it; the keyboard scrolls it, too. */
export const scrolling = (label: string, content: HTMLElement, name = 'box'): HTMLElement =>
  h('div', { class: name, tabindex: 0, role: 'region', 'aria-label': label }, content);

const row = (first: HTMLElement, cells: Child[]) => h('tr', first, ...cells.map((cell) => h('td', cell)));

/** The first column names the rows. A head may have a title. */
export function table(
  attributes: Attributes,
  heads: (string | [head: string, title: string])[],
  rows: Child[][],
  caption?: string,
): HTMLTableElement {
  const head = heads.map((one) => {
    const [text, title = null] = typeof one === 'string' ? [one] : one;
    return h('th', { scope: 'col', title }, text);
  });
  return h(
    'table',
    attributes,
    caption && h('caption', caption),
    heads.length > 0 && h('thead', h('tr', ...head)),
    h('tbody', ...rows.map(([first, ...cells]) => row(h('th', { scope: 'row' }, first), cells))),
  );
}
