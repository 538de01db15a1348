import { h } from '../ui/dom';
import type { Page, View } from './view';

export function createReplay(_page: Page): View {
  const element = h('section', { 'aria-label': 'Replay' });
  return { element, shown() {} };
}
