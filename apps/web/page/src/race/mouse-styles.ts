// How each of many mice is drawn: seven tones that everybody tells apart, and dashes where there are more mice.

const tones = 7;
const dashes = [[], [8, 4], [2, 3]];

export const styleOf = (mouse: number) => ({
  tone: `mouse${mouse % tones}`,
  dash: dashes[Math.floor(mouse / tones) % dashes.length],
});
