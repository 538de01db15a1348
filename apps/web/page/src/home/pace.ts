// How fast time passes on the home page: searches quicker than they were, runs as they were.
import { followsRoute, runAt, type DriveTrack } from '../player/drive';

const searching = 5;
const running = 1;

/** Seconds of the contest in a second: as it was while anybody is on a speed run. */
export function paceAt(tracks: DriveTrack[], time: number): number {
  const fast = tracks.some((track) => {
    const run = track.runs[runAt(track, time)];
    return run && followsRoute(run) && time < run.end / 1e6;
  });
  return fast ? running : searching;
}
