// The drawing as a file of any format, as a picture, as a link.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { MazeData } from '../core/types';
import { fit, numbered } from '../maze/geometry';
import { paintMaze, type Context } from '../maze/painter';
import { readPalette } from '../maze/palette';
import { savePicture } from '../maze/saved';
import { Copyable } from '../ui/copy';
import { showError } from '../ui/field';
import { errorText } from '../ui/format';
import type { Page } from '../page/page';
import { Button } from '../ui/controls';

/** Of the longer side of a saved picture, at most. */
const pixels = 1600;

/** The page's own address with a maze in it. */
const addressWith = (link: string) => `${location.href.split('#')[0]}#maze=${link}`;

/** What it is saved as: a name, what that means, and what does it. */
type Item = [name: string, meaning: string, does: () => Promise<void>];

function itemsOf(page: Page, maze: MazeData, share: (link: string) => void): Item[] {
  const { core, about, save } = page;
  const name = maze.name || 'maze';
  async function saveAs(format: string) {
    const answer = await core.call('write_maze', { maze, format });
    save(answer.file_name, answer.text ?? Uint8Array.from(answer.bytes ?? []), 'application/octet-stream');
  }
  async function saveDrawing() {
    const { svg } = await core.call('picture', { maze });
    save(`${name}.svg`, svg, 'image/svg+xml');
  }
  function savePixels() {
    const palette = readPalette();
    const g = fit(maze, pixels, pixels, 1, numbered);
    return savePicture(save, name, 'png', { g, paint: (context: Context) => paintMaze(context, g, palette, maze) });
  }
  return [
    ...about.formats.map(({ name, summary }): Item => [name, summary, () => saveAs(name)]),
    ['picture', 'an SVG file', saveDrawing],
    ['pixels', 'a PNG file', savePixels],
    ['link', 'to this page, containing the maze', async () => share((await core.call('link', { maze })).link)],
  ];
}

/** What is said of an earlier drawing no longer holds. */
export function Saving({ page, maze }: { page: Page; maze: MazeData }) {
  const [said, say] = useState({ of: maze, error: '', link: '', count: 0 });
  const now = said.of === maze ? said : { error: '', link: '', count: 0 };
  const share = (link: string) => say({ of: maze, error: '', link: addressWith(link), count: said.count + 1 });
  const refusal = useRef<HTMLParagraphElement>(null);
  useLayoutEffect(() => void (now.error && showError(refusal.current!)), [now.error]);
  /** Does it, and says in the core's words why it could not be done. */
  function trying(does: () => Promise<void>) {
    say({ ...now, of: maze, error: '' });
    does().catch((error) => say({ of: maze, error: errorText(error), link: '', count: 0 }));
  }
  return (
    <section class="card" aria-label="Save">
      <h2>Save as</h2>
      <ul class="formats">
        {itemsOf(page, maze, share).map(([name, meaning, does]) => (
          <li>
            <Button label={name} act={() => trying(does)} />
            <span>{meaning}</span>
          </li>
        ))}
      </ul>
      <p class="field-error" role="alert" ref={refusal}>
        {now.error}
      </p>
      {now.link && (
        <Copyable key={now.count} label="Link containing the maze" text={now.link} button="Copy again" atOnce />
      )}
    </section>
  );
}
