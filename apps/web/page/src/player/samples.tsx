// Small pictures of what the layers look like, for the legend. Their tones are classes of the style sheet.
import type { ComponentChildren, SVGAttributes } from 'preact';
import type { LayerName } from './layers';

const line = (tone: string, more: SVGAttributes<SVGPathElement> = {}) => (
  <path class={tone} d="M2 9h32" fill="none" stroke-width={3} {...more} />
);
const box = (tone: string, x: number, width: number) => <rect class={tone} x={x} y={2} width={width} height={14} />;
const dot = (tone: string, more: SVGAttributes<SVGCircleElement> = {}) => (
  <circle class={tone} cx={26} cy={9} r={6} {...more} />
);
const letter = (text: string, more: SVGAttributes<SVGTextElement>) => (
  <text class="f-ink" text-anchor="middle" {...more}>
    {text}
  </text>
);
const levels = (tone: string) => [1, 2, 3, 4, 5, 6].map((level, i) => box(`${tone}${level}`, i * 6, 6));

const shapes: Record<
  | LayerName
  | ('mouse' | 'start' | 'goal' | 'unknown' | 'onwards' | 'chosen' | 'unseen' | 'drawn')
  | ('speeds' | 'ahead' | 'fastest' | 'believed' | 'overlooked'),
  () => ComponentChildren
> = {
  walls: () => line('s-ink', { 'stroke-width': 4 }),
  unknown: () => line('s-faint', { 'stroke-width': 2, 'stroke-dasharray': '5 5' }),
  unseen: () => line('s-faint', { 'stroke-width': 4 }),
  wrong: () => line('s-wrong', { 'stroke-width': 4 }),
  overlooked: () => line('s-wrong', { 'stroke-width': 4, 'stroke-dasharray': '5 5' }),
  visits: () => levels('f-heat'),
  distances: () => letter('12', { x: 18, y: 14, 'font-size': 13 }),
  rays: () => [line('s-muted', { 'stroke-width': 2 }), <path class="s-muted" d="M33 3v12" stroke-width={2} />],
  believed: () => (
    <rect class="s-candidate" x={8} y={3} width={20} height={12} fill="none" stroke-width={2} stroke-dasharray="3 3" />
  ),
  search: () => line('s-to-goal'),
  onwards: () => line('s-onwards', { 'stroke-dasharray': '6 4' }),
  speed: () => [
    line('s-route', { 'stroke-width': 4 }),
    dot('f-route', { r: 8 }),
    letter('3', { class: 'f-paper', x: 26, y: 13, 'font-size': 11, 'font-weight': 600 }),
  ],
  best: () => [
    line('s-muted', { d: 'M2 9h18', 'stroke-width': 2 }),
    dot('s-muted', { fill: 'none', 'stroke-width': 2 }),
  ],
  candidates: () => line('s-candidate', { 'stroke-width': 3, opacity: 0.75 }),
  chosen: () => line('s-candidate', { 'stroke-width': 7 }),
  drawn: () => line('s-to-goal', { 'stroke-width': 4 }),
  mms: () => [
    box('f-mms', 2, 14),
    line('s-to-goal', { d: 'M22 2v14', 'stroke-width': 4 }),
    letter('a', { x: 31, y: 14, 'font-size': 12 }),
  ],
  speeds: () => levels('f-speed'),
  ahead: () => line('s-muted', { 'stroke-width': 1.5 }),
  fastest: () => line('s-ink', { 'stroke-width': 2, 'stroke-dasharray': '4 4' }),
  mouse: () => <path class="f-ink" d="M18 1l7 15-7-3-7 3z" />,
  start: () => [box('f-start', 10, 16), letter('S', { x: 18, y: 13, 'font-size': 11 })],
  goal: () => [box('f-goal', 10, 16), letter('G', { x: 18, y: 13, 'font-size': 11 })],
};

export type SampleName = keyof typeof shapes;

export const Sample = ({ name }: { name: SampleName }) => (
  <svg class="sample" viewBox="0 0 36 18" width={36} height={18} aria-hidden="true">
    {shapes[name]()}
  </svg>
);
