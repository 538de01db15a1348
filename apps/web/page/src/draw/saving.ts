// The drawing as a file of any format, as a picture, as a link.
import type { MazeData } from '../core/types';
import { fit, numbered } from '../maze/geometry';
import { paintMaze, type Context } from '../maze/painter';
import { readPalette } from '../maze/palette';
import { savePicture } from '../maze/saved';
import { createCopyable } from '../ui/copy';
import { h } from '../ui/dom';
import { showError } from '../ui/field';
import { errorText } from '../ui/format';
import type { Page } from '../page/page';

/** Of the longer side of a saved picture, at most. */
const pixels = 1600;

/** The page's own address with a maze in it. */
const addressWith = (link: string) => `${location.href.split('#')[0]}#maze=${link}`;

export function createSaving(page: Page, drawing: () => MazeData) {
  const refusal = h('p.field-error', { role: 'alert' });
  const link = createCopyable('Link containing the maze', 'Copy again');
  link.element.hidden = true;

  /** Does it, and says in the core's words why it could not be done. */
  const trying = (does: () => Promise<void>) => () => {
    refusal.replaceChildren();
    does().catch((error: unknown) => {
      refusal.replaceChildren(errorText(error));
      showError(refusal);
    });
  };
  const saveAs = async (format: string) => {
    const answer = await page.core.call('write_maze', { maze: drawing(), format });
    page.save(answer.file_name, answer.text ?? Uint8Array.from(answer.bytes ?? []), 'application/octet-stream');
  };
  const saveDrawing = async () => {
    const { svg } = await page.core.call('picture', { maze: drawing() });
    page.save(`${drawing().name || 'maze'}.svg`, svg, 'image/svg+xml');
  };
  const savePixels = () => {
    const [maze, palette] = [drawing(), readPalette()];
    const g = fit(maze, pixels, pixels, 1, numbered);
    const paint = (context: Context) => paintMaze(context, g, palette, maze);
    return savePicture(page.save, maze.name || 'maze', 'png', { g, paint });
  };
  const copyLink = async () => {
    const answer = await page.core.call('link', { maze: drawing() });
    link.show(addressWith(answer.link));
    link.element.hidden = false;
    await link.copy();
  };
  const item = (name: string, meaning: string, does: () => Promise<void>) =>
    h('li', h('button', { type: 'button', onclick: trying(does) }, name), h('span', meaning));
  const items = [
    ...page.about.formats.map(({ name, summary }) => item(name, summary, () => saveAs(name))),
    item('picture', 'an SVG file', saveDrawing),
    item('pixels', 'a PNG file', savePixels),
    item('link', 'to this page, containing the maze', copyLink),
  ];
  return {
    element: h(
      'section.card',
      { 'aria-label': 'Save' },
      h('h2', 'Save as'),
      h('ul.formats', ...items),
      refusal,
      link.element,
    ),
    /** The drawing has changed: what was said of an earlier one no longer holds. */
    changed() {
      refusal.replaceChildren();
      link.element.hidden = true;
    },
  };
}
