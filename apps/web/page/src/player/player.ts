// The player: one contest, or two beside each other on one clock.
import type { Play } from '../core/types';
import { h } from '../ui/dom';
import type { Page } from '../views/view';

/** A contest, and its record as text, to be saved. */
export interface Shown {
  play: Play;
  record: string;
}

export interface Player {
  element: HTMLElement;
  /** Shows one or two of them from the beginning; what was shown before is gone. */
  show(plays: Shown[]): void;
  /** Pauses: call it when the player is hidden. */
  stop(): void;
}

export function createPlayer(_page: Page): Player {
  const element = h('div', { class: 'player' });
  return { element, show() {}, stop() {} };
}
