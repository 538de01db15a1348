// Elements in one line. Text is always text: nothing here takes markup.

export type Child = Node | string | number | null | undefined | false;

/** Attributes; `on...` are listeners, all others are set as they stand, false and null are left out. */
export type Attributes = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

const isAttributes = (first: Attributes | Child): first is Attributes =>
  typeof first === 'object' && first !== null && !(first instanceof Node);

function built<Made extends Element>(element: Made, classes: string[], first: Attributes | Child, more: Child[]): Made {
  const [attributes, children] = isAttributes(first) ? [first, more] : [{}, [first, ...more]];
  if (classes.length > 0) element.setAttribute('class', classes.join(' '));
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value as EventListener);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  for (const child of children)
    if (child !== null && child !== undefined && child !== false)
      element.append(typeof child === 'number' ? String(child) : child);
  return element;
}

/** `h('button.quiet', { onclick: play }, 'Play')`: a tag with its classes, attributes where it has others, and content. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  name: Tag | `${Tag}.${string}`,
  first?: Attributes | Child,
  ...more: Child[]
): HTMLElementTagNameMap[Tag] {
  const [tag, ...classes] = name.split('.');
  return built(document.createElement(tag as Tag), classes, first, more);
}

/** The same for pictures. */
export function svg(name: string, first?: Attributes | Child, ...more: Child[]): SVGElement {
  const [tag, ...classes] = name.split('.');
  return built(document.createElementNS('http://www.w3.org/2000/svg', tag) as SVGElement, classes, first, more);
}
