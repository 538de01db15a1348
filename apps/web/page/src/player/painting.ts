// One play, painted at any moment on any canvas: on the stage, for a picture, for a film.
import { paintGround, paintLetters, paintNumbers } from '../maze/painter';
import { createMoment, goTo } from './drive';
import { createPose, poseAt } from './motion';
import type { Brush } from './paint/brush';
import { paintBodies } from './paint/bodies';
import { paintCandidates } from './paint/candidates';
import { paintDistances } from './paint/distances';
import { paintDriven, paintDriving, paintFastest, poseOf } from './paint/drive';
import { paintFloor } from './paint/floor';
import { paintMmsTexts } from './paint/mms-texts';
import { paintMouse, paintRays } from './paint/mouse';
import { paintPlan } from './paint/plan';
import { paintWalls } from './paint/walls';
import { paintBest, paintSearchRun, paintSpeedRun } from './paint/ways';
import type { Track } from './track';

/** Of a cell: paths between posts are to be seen. */
const mouseInSeconds = 0.6;

/** Where the mouse of a play is. */
export type Place = ReturnType<typeof createPlace>;

export function createPlace(track: Track) {
  const pose = createPose();
  const moment = track.drive ? createMoment() : null;
  return {
    pose,
    /** Null in other worlds than that of seconds. */
    moment,
    /** Goes to that time, which is in that frame or, by a share, on the way to the next one. */
    look(time: number, frame: number, share: number) {
      poseAt(track, frame, share, pose);
      if (!track.drive || !moment) return;
      goTo(track.drive, time, moment);
      poseOf(moment, pose);
    },
  };
}

/** Everything but the mouse and its rays; `plan` also where it means to go. */
export function paintBelow(brush: Brush, plan = false) {
  const { context, g, palette, track, layers, past } = brush;
  const { draws } = track.play.traits;
  const crowded = plan || layers.search || layers.speed || layers.distances !== 'none' || draws;
  paintGround(context, g, palette);
  paintFloor(brush);
  paintLetters(context, g, palette, track.maze, crowded);
  paintWalls(brush);
  if (layers.best) (track.drive ? paintFastest : paintBest)(brush);
  if (layers.search && !track.drive) paintSearchRun(brush);
  if (layers.speed) (track.drive ? paintDriven : paintSpeedRun)(brush);
  if (layers.mms && draws) paintMmsTexts(brush);
  if (layers.distances !== 'none') paintDistances(brush);
  if (layers.candidates) paintCandidates(brush);
  paintNumbers(context, g, palette);
  if (plan && track.run[past.frame] === 0) paintPlan(brush);
}

/** The mouse and what it sees, on top of that. */
export function paintAbove(brush: Brush, { pose, moment }: Place) {
  const { layers, track } = brush;
  if (layers.rays) paintRays(brush);
  if (layers.speed && moment) paintDriving(brush, moment);
  paintMouse(brush, pose, track.drive ? mouseInSeconds : 1);
  if (layers.rays && moment) paintBodies(brush, moment);
}
