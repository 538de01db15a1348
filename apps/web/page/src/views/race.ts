import { h } from '../ui/dom';
import type { EarlyPage, View } from './view';

export function createRace(_page: EarlyPage): View {
  const element = h('section', { 'aria-label': 'Race' });
  return { element, shown() {} };
}
