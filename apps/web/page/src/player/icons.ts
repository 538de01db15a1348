// The signs on the player's buttons.
import { svg } from '../ui/dom';

const shapes = {
  play: 'M6 4l13 8-13 8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  back: 'M17 4L7 12l10 8zM4 4h3v16H4z',
  forward: 'M7 4l10 8-10 8zM17 4h3v16h-3z',
  start: 'M20 4l-8 8 8 8zM12 4l-8 8 8 8zM2 4h2v16H2z',
  end: 'M4 4l8 8-8 8zM12 4l8 8-8 8zM20 4h2v16h-2z',
  loop: 'M5 11a7 7 0 0 1 12-4l-2 2h6V3l-2.5 2.5A10 10 0 0 0 2 11zM19 13a7 7 0 0 1-12 4l2-2H3v6l2.5-2.5A10 10 0 0 0 22 13z',
};

export type Icon = keyof typeof shapes;

export function icon(name: Icon): SVGElement {
  const path = svg('path', { d: shapes[name], fill: 'currentColor' });
  return svg('svg', { viewBox: '0 0 24 24', width: 18, height: 18, 'aria-hidden': 'true', focusable: 'false' }, path);
}
