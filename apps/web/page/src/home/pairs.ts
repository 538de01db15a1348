// The races of the home page: which two mice meet where. Each has a story that can be seen.
import type { Core } from '../core/client';
import type { Shown } from '../player/side';

export interface Pair {
  maze: string;
  mice: [string, string];
}

/** Who stops searching early is often first at the goal, and slower in the end. */
export const pairs: Pair[] = [
  { maze: 'contest-02', mice: ['ariadne', 'flood'] },
  { maze: 'contest-04', mice: ['flood-return', 'ariadne'] },
  { maze: 'contest-04', mice: ['certify', 'flood'] },
];

/** With published figures, so that what is seen could have been seen at a contest. */
const conditions = { world: 'seconds', robot: 'classic', rules: 'all-japan' };

export type Met = Shown;

export async function meet(core: Core, { maze: name, mice }: Pair): Promise<[Met, Met]> {
  const { maze } = await core.call('builtin_maze', { name });
  const [one, other] = mice.map((mouse) => core.call('contest', { mouse, maze, seed: 1, ...conditions }));
  return [await one, await other];
}
