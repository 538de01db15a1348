import { h } from '../ui/dom';
import type { Page, View } from './view';

export function createRace(_page: Page): View {
  const element = h('section', { 'aria-label': 'Race' });
  return { element, shown() {} };
}
