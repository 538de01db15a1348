// The drawing survives a reload, where the browser keeps anything for the page.
import type { MazeData } from '../core/types';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';

const key = 'drawing';
const earlierKey = 'labmouse drawing';

/** What earlier versions kept, in another place; from now on it is kept here. */
function fromBefore(): string | null {
  const link = localStorage.getItem(earlierKey);
  localStorage.removeItem(earlierKey);
  return link;
}

/** What was drawn before, or null. The core's link is kept: it tells itself whether it is whole. */
export async function restoreDrawing(page: Page): Promise<MazeData | null> {
  try {
    const link = (await page.shelf.read(key)) ?? fromBefore();
    return typeof link === 'string' ? (await page.core.call('read_link', { link })).maze : null;
  } catch {
    return null;
  }
}

/** Keeps each drawing that it is given, the latest one at last. */
export function createKeeper(page: Page): (maze: MazeData) => void {
  const latest = createLatest(
    (maze: MazeData) => page.core.call('link', { maze }),
    ({ link }) => void page.shelf.write(key, link),
    () => undefined,
    300,
  );
  return (maze) => latest.ask(maze);
}
