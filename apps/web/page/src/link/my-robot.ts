// The robot of the view Robot, which Live and Race offer beside those that the core brings. As the core takes it: its
// name, and in the lines below it the text of its file.

/** What a robot began from: one that the core brings, or a file's text. */
export type Origin = { name: string; text: string | null };

/** A robot as the browser keeps it, with what it began from where that is known, and an address of what was asked of it. */
export interface KeptRobot {
  name: string;
  text: string;
  origin?: Origin;
  at?: string | null;
}

let mine: string | null = null;
const listeners = new Set<() => void>();

/** Null while there is none. */
export const myRobot = (): string | null => mine;

export const nameOf = (robot: string): string => robot.split('\n', 1)[0];
export const isMine = (robot: string): boolean => robot.includes('\n');

/** The same without what only people read, for an address. */
export function withoutRemarks(robot: string): string {
  const [name, ...lines] = robot.split('\n');
  const bare = lines.map((line) => line.replace(/\s*#.*$/, '').trim()).filter(Boolean);
  return [name, ...bare].join('\n');
}

export function setMyRobot(robot: string | null) {
  if (robot === mine) return;
  mine = robot;
  for (const listener of listeners) listener();
}

/** Calls whenever it is another one; the function returned ends that. */
export function onMyRobot(listener: () => void): () => void {
  listeners.add(listener);
  return () => void listeners.delete(listener);
}
