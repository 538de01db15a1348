import { h } from '../ui/dom';
import type { Page, View } from './view';

export function createLive(_page: Page): View {
  const element = h('section', { 'aria-label': 'Live' });
  return { element, shown() {} };
}
