import { h } from '../ui/dom';
import type { Page, View } from './view';

export function createDraw(_page: Page): View {
  const element = h('section', { 'aria-label': 'Draw' });
  return { element, shown() {} };
}
