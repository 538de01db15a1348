// What the measures mean that stand in several places, each under one name.
export const boundMeaning = 'the best possible score: that of a mouse that knows the maze';
export const mmsBoundMeaning = 'the best possible score under the rules of mms';
/** The kinds of turns of a robot that drives, by the names that its files and lists have for them. */
export const turnMeanings: [name: string, meaning: string][] = [
  ['45', 'from the middle of a cell onto a diagonal, and backwards off it'],
  ['90', 'a quarter turn from cell to cell'],
  ['135', 'from the middle of a cell onto a diagonal that leads back'],
  ['180', 'a half turn around a wall, from cell to cell'],
  ['V90', 'a quarter turn from diagonal to diagonal'],
  ['S90', 'the small quarter turn inside one cell, which searches use'],
];
export const optimumMeaning = 'the optimum: steps of the shortest speed run in this maze';
