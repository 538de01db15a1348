// How each of many mice is drawn: five tones that everybody tells apart, and four kinds of lines, for 20 mice.

const tones = 5;
/** Solid, dashed, dotted, and both in turn. */
const dashes = [[], [10, 5], [2, 4], [10, 4, 2, 4]];

export const styleOf = (mouse: number) => ({
  tone: `mouse${mouse % tones}`,
  dash: dashes[Math.floor(mouse / tones) % dashes.length],
});
