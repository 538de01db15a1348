// Numbers and places as text, the same wherever they stand.
import type { MazeData } from '../core/types';

export const headings = ['north', 'north-east', 'east', 'south-east', 'south', 'south-west', 'west', 'north-west'];

export const counted = (count: number, one: string, many = `${one}s`) => `${count} ${count === 1 ? one : many}`;

/** A place in half cells, as a cell: (3,4), or (3.5,4) between two. */
export const placeText = (x: number, y: number) => `(${(x - 1) / 2},${(y - 1) / 2})`;

/** Fixed decimals, so that numbers that tick stay where they are. */
export const decimal = (value: number, digits = 3) => value.toFixed(digits);

/** As many decimals as there are, three at most. */
export const short = (value: number) => String(Math.round(value * 1000) / 1000);

export const percent = (share: number) => `${(100 * share).toFixed(1)} %`;

/** `capstone-1, 12 × 12 cells` */
export const sizeText = ({ width, height }: MazeData) => `, ${width} × ${height} cells`;
export const mazeText = (maze: MazeData) => `${maze.name}${sizeText(maze)}`;
