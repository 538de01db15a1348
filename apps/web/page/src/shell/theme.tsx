// Light, dark, or as the system has it; paper is always light.
import { Select } from '../ui/controls';
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

let theme = kept();

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

/** The theme that was kept holds from now on. */
export function startTheme() {
  apply(theme);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', tonesChanged);
  addEventListener('beforeprint', () => (setPaper(true), apply('light')));
  addEventListener('afterprint', () => (setPaper(false), apply(theme)));
}

export const ThemeSwitch = () => (
  <Select
    aria-label="Theme"
    options={themes.map((name) => [name, name[0].toUpperCase() + name.slice(1)])}
    value={theme}
    choose={(name) => {
      theme = name as Theme;
      keep(theme);
      apply(theme);
    }}
  />
);
