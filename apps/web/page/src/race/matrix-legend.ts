// The legend of the matrix.
import { h, svg } from '../ui/dom';
import { toneLabels, toneName } from './scale';

const picture = (name: string | undefined, ...content: SVGElement[]) =>
  svg('svg', { width: 14, height: 14, viewBox: '0 0 14 14', 'aria-hidden': 'true', class: name }, ...content);

const sign = (path: string, name?: string) => picture(name, svg('path', { d: path }));

/** Some failed: the corner in its two tones, as it is on light and on dark cells. */
const corner = (step: number, tone: string) =>
  picture(
    'corner',
    svg('rect', { width: 14, height: 14, class: toneName(step) }),
    svg('path', { d: 'M0 0 L7 0 L0 7 Z', class: tone }),
  );

/** What the tones and signs of the matrix mean. */
export function matrixLegend(): HTMLElement {
  const swatches = toneLabels.map((label, step) => h('li', h('span', { class: `swatch ${toneName(step)}` }), label));
  return h(
    'div.scale',
    h('span', 'score / best, mean over the finished contests:'),
    h(
      'ul',
      ...swatches,
      h('li', sign('M3 3 L11 11 M11 3 L3 11'), 'all contests failed'),
      h('li', corner(1, 'on-light'), corner(5, 'on-dark'), 'some failed'),
      h('li', sign('M3 7 L11 7', 'dash'), 'no route, or no contest'),
    ),
  );
}
