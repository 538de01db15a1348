// The tones of the page's style sheet, for canvases.
import '../styles/maze.css';

// prettier-ignore
const tones = [
  'paper', 'ink', 'muted', 'faint', 'post', 'start', 'goal', 'route', 'to-goal', 'onwards', 'wrong', 'candidate',
  'panel', 'line', 'discovered', 'visited', 'heat1', 'heat2', 'heat3', 'heat4', 'heat5', 'heat6',
] as const;

export type Tone = (typeof tones)[number];

export interface Palette extends Record<Tone, string> {
  /** From one visit to the most. */
  heat: string[];
  /** The page's typeface, for `context.font`. */
  family: string;
  dark: boolean;
}

/** Whether the page shows itself in dark tones. */
function isDark(): boolean {
  const { theme } = document.documentElement.dataset;
  return theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  const read = Object.fromEntries(tones.map((tone) => [tone, style.getPropertyValue(`--${tone}`).trim()]));
  const colours = read as Record<Tone, string>;
  const heat = [colours.heat1, colours.heat2, colours.heat3, colours.heat4, colours.heat5, colours.heat6];
  return { ...colours, heat, family: style.fontFamily, dark: isDark() };
}

/** Calls back whenever the tones may have changed. Returns how to stop it. */
export function watchTheme(changed: () => void): () => void {
  const media = matchMedia('(prefers-color-scheme: dark)');
  const observer = new MutationObserver(changed);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
  media.addEventListener('change', changed);
  return () => {
    observer.disconnect();
    media.removeEventListener('change', changed);
  };
}
