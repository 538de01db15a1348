// The walls: those of the maze, and what the mouse knows of them by now.
import { columnAt, rowAt } from '../../maze/geometry';
import { fillBorder, fillWall, paintPosts } from '../../maze/painter';
import { knows } from '../past';
import { thick, type Brush } from './brush';

/** Whether a wall is closed where it does not depend on the mouse: on the border. */
function onBorder(brush: Brush, wall: number): boolean {
  const { g, track } = brush;
  return wall < track.cells ? wall >= track.cells - g.width : (wall - track.cells) % g.width === g.width - 1;
}

/** Unknown walls as broken lines, open or not: six dashes and gaps to a cell. */
function paintUnknown(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  const width = thick(g, 0.03);
  const back = Math.floor(width / 2);
  context.fillStyle = palette.faint;
  for (let wall = 0; wall < 2 * track.cells; ++wall) {
    if (onBorder(brush, wall) || knows(past, wall)) continue;
    const cell = wall % track.cells;
    const x = cell % g.width;
    const y = (cell - x) / g.width;
    const dash = g.pitch / 7;
    for (let i = 1; i < 7; i += 2) {
      const at = Math.round(i * dash);
      const length = Math.round((i + 1) * dash) - at;
      if (wall < track.cells) context.fillRect(columnAt(g, x) + at, rowAt(g, y + 1) - back, length, width);
      else context.fillRect(columnAt(g, x + 1) - back, rowAt(g, y + 1) + at, width, length);
    }
  }
}

function paintClosed(brush: Brush, known: boolean) {
  const { context, g, track, past } = brush;
  for (let wall = 0; wall < track.closed.length; ++wall)
    if (track.closed[wall] !== 0 && !onBorder(brush, wall) && knows(past, wall) === known) fillWall(context, g, wall);
}

/** Walls that a program for mms drew. */
function paintDrawn(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  for (let wall = 0; wall < 2 * track.cells; ++wall) {
    if (past.drawn[wall] === 0) continue;
    context.fillStyle = track.closed[wall] !== 0 ? palette['to-goal'] : palette.wrong;
    fillWall(context, g, wall);
  }
}

function paintBorder(brush: Brush) {
  const { context, g, palette, track } = brush;
  context.fillStyle = palette.ink;
  for (let wall = track.cells - g.width; wall < track.cells; ++wall) fillWall(context, g, wall);
  for (let wall = track.cells + g.width - 1; wall < 2 * track.cells; wall += g.width) fillWall(context, g, wall);
  fillBorder(context, g);
}

export function paintWalls(brush: Brush) {
  const { context, g, palette, track, layers } = brush;
  const { draws } = track.play.traits;
  const whole = layers.walls === 'whole';
  if (!whole && !draws) paintUnknown(brush);
  paintPosts(context, g, palette);
  if (whole || draws || layers.wrong) {
    context.fillStyle = draws && whole ? palette.ink : layers.wrong && !draws ? palette.wrong : palette.faint;
    paintClosed(brush, false);
  }
  context.fillStyle = palette.ink;
  paintClosed(brush, true);
  paintBorder(brush);
  if (draws && (layers.mms || !whole)) paintDrawn(brush);
}
