// The languages in which mice are written in the page.
import type { Language } from './runtime';

export const languages: Language[] = [];
