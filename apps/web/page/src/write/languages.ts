// The languages in which mice are written in the page.
import { javascript } from './javascript/language';
import { python } from './python/language';
import type { Language } from './runtime';

export const languages: Language[] = [javascript, python];
