// The page's tones as they are now, for what is painted: canvases have to be painted anew when they change.

const listeners = new Set<() => void>();

/** The colour of a tone of styles/page.css: `tone('ink')`. */
export const tone = (name: string) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim() || '#808080';

/** Calls whenever the tones have changed; the function returned ends that. */
export function onTones(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

export function tonesChanged() {
  for (const listener of listeners) listener();
}

/** While the page is printed: the width of a sheet in CSS pixels, for what is painted to its width; else null. */
export const paperWidth = (): number | null => ('paper' in document.documentElement.dataset ? 700 : null);

/** Begins or ends the printing. */
export function setPaper(on: boolean) {
  if (on) document.documentElement.dataset.paper = '';
  else delete document.documentElement.dataset.paper;
}
