// Where trees of components begin.
import { render, type ComponentChild } from 'preact';

/** A section with a tree of its own; `draw` it after what it shows has changed. */
export function createRoot(name: string, label: string, tree: () => ComponentChild) {
  const element = document.createElement('section');
  element.className = name;
  element.setAttribute('aria-label', label);
  return { element, draw: () => render(tree(), element) };
}
