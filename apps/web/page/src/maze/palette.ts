// The tones of the page's style sheet, for canvases.
import '../styles/maze.css';
import { tone } from '../ui/tones';

// prettier-ignore
const tones = [
  'paper', 'ink', 'muted', 'faint', 'post', 'start', 'goal', 'route', 'to-goal', 'onwards', 'wrong', 'candidate',
  'panel', 'line', 'discovered', 'visited', 'heat1', 'heat2', 'heat3', 'heat4', 'heat5', 'heat6',
  'speed1', 'speed2', 'speed3', 'speed4', 'speed5', 'speed6',
] as const;

export type Tone = (typeof tones)[number];

export interface Palette extends Record<Tone, string> {
  /** From one visit to the most. */
  heat: string[];
  /** From rest to the highest speed. */
  speeds: string[];
  /** The page's typeface, for `context.font`. */
  family: string;
}

export function readPalette(): Palette {
  const colours = Object.fromEntries(tones.map((name) => [name, tone(name)])) as Record<Tone, string>;
  const heat = [colours.heat1, colours.heat2, colours.heat3, colours.heat4, colours.heat5, colours.heat6];
  const speeds = [colours.speed1, colours.speed2, colours.speed3, colours.speed4, colours.speed5, colours.speed6];
  return { ...colours, heat, speeds, family: getComputedStyle(document.documentElement).fontFamily };
}
