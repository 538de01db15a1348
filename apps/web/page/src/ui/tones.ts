// The page's tones as they are now, for what is painted: canvases have to be painted anew when they change.

const listeners = new Set<() => void>();

let probe: HTMLElement | undefined;

/** The colour of a tone of the style sheets, as a canvas takes it: `tone('ink')`. */
export function tone(name: string): string {
  // A custom property is text; only where it is used does the browser choose between its light and its dark colour.
  if (!probe) {
    probe = document.body.appendChild(document.createElement('i'));
    probe.hidden = true;
  }
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}

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
