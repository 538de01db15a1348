// Small pictures of what the layers look like, for the legend. Their tones are classes of the style sheet.
import type { Child } from '../ui/dom';
import { svg } from '../ui/dom';
import type { LayerName } from './layers';

const line = (className: string, attributes = {}) =>
  svg('path', { class: className, d: 'M2 9h32', fill: 'none', 'stroke-width': 3, ...attributes });
const box = (className: string, x: number, width: number) =>
  svg('rect', { class: className, x, y: 2, width, height: 14 });
const dot = (className: string, attributes = {}) =>
  svg('circle', { class: className, cx: 26, cy: 9, r: 6, ...attributes });

const shapes: Record<
  | LayerName
  | ('mouse' | 'start' | 'goal' | 'unknown' | 'onwards' | 'chosen' | 'unseen' | 'drawn')
  | ('speeds' | 'ahead' | 'fastest'),
  () => Child[]
> = {
  walls: () => [line('s-ink', { 'stroke-width': 4 })],
  unknown: () => [line('s-faint', { 'stroke-width': 2, 'stroke-dasharray': '5 5' })],
  unseen: () => [line('s-faint', { 'stroke-width': 4 })],
  wrong: () => [line('s-wrong', { 'stroke-width': 4 })],
  visits: () => [1, 2, 3, 4, 5, 6].map((level, i) => box(`f-heat${level}`, i * 6, 6)),
  distances: () => [svg('text', { class: 'f-ink', x: 18, y: 14, 'text-anchor': 'middle', 'font-size': 13 }, '12')],
  rays: () => [
    line('s-muted', { 'stroke-width': 2 }),
    svg('path', { class: 's-muted', d: 'M33 3v12', 'stroke-width': 2 }),
  ],
  exploration: () => [line('s-to-goal')],
  onwards: () => [line('s-onwards', { 'stroke-dasharray': '6 4' })],
  speed: () => [
    line('s-route', { 'stroke-width': 4 }),
    dot('f-route', { r: 8 }),
    svg('text', { class: 'f-paper', x: 26, y: 13, 'text-anchor': 'middle', 'font-size': 11, 'font-weight': 600 }, '3'),
  ],
  best: () => [
    line('s-muted', { d: 'M2 9h18', 'stroke-width': 2 }),
    dot('s-muted', { fill: 'none', 'stroke-width': 2 }),
  ],
  candidates: () => [line('s-candidate', { 'stroke-width': 3, opacity: 0.75 })],
  chosen: () => [line('s-candidate', { 'stroke-width': 7 })],
  drawn: () => [line('s-to-goal', { 'stroke-width': 4 })],
  mms: () => [
    box('f-mms', 2, 14),
    line('s-to-goal', { d: 'M22 2v14', 'stroke-width': 4 }),
    svg('text', { class: 'f-ink', x: 31, y: 14, 'text-anchor': 'middle', 'font-size': 12 }, 'a'),
  ],
  speeds: () => [1, 2, 3, 4, 5, 6].map((level, i) => box(`f-speed${level}`, i * 6, 6)),
  ahead: () => [line('s-muted', { 'stroke-width': 1.5 })],
  fastest: () => [line('s-ink', { 'stroke-width': 2, 'stroke-dasharray': '4 4' })],
  mouse: () => [svg('path', { class: 'f-ink', d: 'M18 1l7 15-7-3-7 3z' })],
  start: () => [
    box('f-start', 10, 16),
    svg('text', { class: 'f-ink', x: 18, y: 13, 'text-anchor': 'middle', 'font-size': 11 }, 'S'),
  ],
  goal: () => [
    box('f-goal', 10, 16),
    svg('text', { class: 'f-ink', x: 18, y: 13, 'text-anchor': 'middle', 'font-size': 11 }, 'G'),
  ],
};

export type Sample = keyof typeof shapes;

export const sample = (name: Sample): SVGElement =>
  svg(
    'svg',
    { class: 'sample', viewBox: '0 0 36 18', width: 36, height: 18, 'aria-hidden': 'true' },
    ...shapes[name](),
  );
