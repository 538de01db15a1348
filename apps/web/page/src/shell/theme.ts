// Light, dark, or as the system has it; paper is always light.
import { h } from '../ui/dom';
import { setPaper, tonesChanged } from '../ui/tones';

const themes = ['auto', 'light', 'dark'] as const;
type Theme = (typeof themes)[number];
const key = 'labmouse-theme';

// A page from a disk may have no storage, and asking for it may throw.
function kept(): Theme {
  try {
    return themes.find((theme) => theme === localStorage.getItem(key)) ?? 'auto';
  } catch {
    return 'auto';
  }
}

function keep(theme: Theme) {
  try {
    localStorage.setItem(key, theme);
  } catch {
    // It holds until the page is closed.
  }
}

function apply(theme: Theme) {
  if (theme === 'auto') delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  tonesChanged();
}

/** The switch; the theme that was kept holds from now on. */
export function themeSwitch(): HTMLElement {
  let theme = kept();
  apply(theme);
  const choice = h(
    'select',
    {
      'aria-label': 'Theme',
      onchange: () => {
        theme = choice.value as Theme;
        keep(theme);
        apply(theme);
      },
    },
    ...themes.map((name) =>
      h('option', { value: name, selected: name === theme }, name[0].toUpperCase() + name.slice(1)),
    ),
  );
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', tonesChanged);
  addEventListener('beforeprint', () => (setPaper(true), apply('light')));
  addEventListener('afterprint', () => (setPaper(false), apply(theme)));
  return choice;
}
