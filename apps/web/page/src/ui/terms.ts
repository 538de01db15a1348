// What the measures mean that stand in several places, each under one name.
import type { Play } from '../core/types';

export const boundMeaning = 'the best possible score: that of a mouse that knows the maze';
export const mmsBoundMeaning = 'the best possible score under the rules of mms';
export const driveBoundMeaning = 'the best possible score: that of the fastest run, made at once';
export const optimumMeaning = 'the optimum: steps of the shortest speed run in this maze';

export const boundOf = (world: Play['world']) =>
  world === 'mms' ? mmsBoundMeaning : world === 'seconds' ? driveBoundMeaning : boundMeaning;
