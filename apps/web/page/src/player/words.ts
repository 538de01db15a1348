// Words and numbers about a moment of a play.
import type { Play } from '../core/types';
import { counted, decimal, headings, placeText } from './figures';
import type { Scene } from './scene';
import type { Track } from './track';

type Side = { track: Track; scene: Scene };
type Named = Side & { name: string };

export function runText({ track, scene }: Side): string {
  const { frame } = scene.past;
  if (frame === track.last) return track.play.ended ? 'ended' : 'incomplete';
  return track.play.traits.runs[track.run[frame]];
}

export function poseText({ track, scene }: Side): string {
  const { frame } = scene.past;
  return `${placeText(track.x[frame], track.y[frame])} ${headings[track.heading[frame] & 7]}`;
}

export function readingText({ track, scene }: Side): string {
  const { left, ahead, right } = track.play;
  const { frame } = scene.past;
  return frame < left.length ? `${left[frame]}, ${ahead[frame]}, ${right[frame]}` : '–';
}

/** What the mouse does next, and what became of it. */
export function actionText({ track, scene }: Side): string {
  const { frame } = scene.past;
  if (frame === track.last) return '–';
  const stopped = track.drive ? ', and crashes' : ', stopped by a wall';
  return track.play.action[frame] + (track.play.blocked[frame] ? stopped : '');
}

/** The same of a contest in seconds. */
function driveText(side: Named): string {
  const { track, scene } = side;
  const { time, v } = scene.moment!;
  const { frame } = scene.past;
  const when = `${side.name} at ${decimal(time)} of ${decimal(track.time[track.last])} s, ${runText(side)}`;
  const where = `${when}: at ${poseText(side)}, ${decimal(v, 2)} m/s`;
  return frame === track.last ? `${where}. ${track.play.outcome}.` : `${where}. Now: ${actionText(side)}.`;
}

/** One sentence on where a play is, for those who hear it. */
export function momentText(side: Named): string {
  const { track, scene } = side;
  if (scene.moment) return driveText(side);
  const { frame } = scene.past;
  const when = `${side.name} after ${frame} of ${counted(track.last, 'step')}, ${runText(side)}`;
  const where = `${when}: at ${poseText(side)}`;
  if (frame === track.last) return `${where}. ${track.play.outcome}.`;
  const reads = track.play.left.length > 0 ? ` Open cells to the left, ahead, to the right: ${readingText(side)}.` : '';
  return `${where}.${reads} Next: ${actionText(side)}.`;
}

/** What plays beside each other are called: two of one mouse by their mazes, too, or by their place. */
export function namesOf(plays: Pick<Play, 'mouse' | 'maze'>[]): string[] {
  const tellApart = (names: string[]) => new Set(names).size === names.length;
  const mice = plays.map(({ mouse }) => mouse);
  if (tellApart(mice)) return mice;
  const mazes = plays.map(({ mouse, maze }) => `${mouse}, ${maze.name || 'a maze'}`);
  return tellApart(mazes) ? mazes : mice.map((mouse, i) => `${mouse}, ${i + 1}`);
}
