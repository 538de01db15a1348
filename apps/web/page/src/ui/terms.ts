// What the measures mean that stand in several places, each under one name.
export const boundMeaning = 'the best possible score: that of a mouse that knows the maze';
export const mmsBoundMeaning = 'the best possible score under the rules of mms';
export const optimumMeaning = 'the optimum: steps of the shortest speed run in this maze';
