// The walls: those of the maze, and what the mouse knows of them by now.
import { columnAt, rowAt } from '../../maze/geometry';
import { fillBorder, fillWall, paintPosts } from '../../maze/painter';
import { knows } from '../past';
import { eachRun, thick, type Brush } from './brush';

const solid: number[] = [];

/**
 * Three dashes to a cell, on whole pixels, as a pattern that begins with the first of them; and how far that is from the
 * cell's side.
 */
function dashesOf(pitch: number): { first: number; pattern: number[] } {
  const ends = [1, 2, 3, 4, 5, 6, 8].map((part) => Math.round((part * pitch) / 7));
  const pattern = ends.slice(1).map((end, i) => end - ends[i]);
  return { first: ends[0], pattern };
}

/** Unknown walls as broken lines, open or not. */
function paintUnknown(brush: Brush) {
  const { context, g, palette, track, past } = brush;
  const { first, pattern } = dashesOf(g.pitch);
  context.strokeStyle = palette.faint;
  context.lineWidth = thick(g, 0.03);
  context.lineCap = 'butt';
  context.setLineDash(pattern);
  // Where the line's middle is, so that its rims are on whole pixels.
  const middle = (context.lineWidth % 2) / 2;
  context.beginPath();
  for (let y = 0; y + 1 < g.height; ++y)
    eachRun(
      g.width,
      (x) => !knows(past, y * g.width + x),
      (from, to) => {
        context.moveTo(columnAt(g, from) + first, rowAt(g, y + 1) + middle);
        context.lineTo(columnAt(g, to), rowAt(g, y + 1) + middle);
      },
    );
  for (let x = 0; x + 1 < g.width; ++x)
    eachRun(
      g.height,
      (y) => !knows(past, track.cells + y * g.width + x),
      (from, to) => {
        context.moveTo(columnAt(g, x + 1) + middle, rowAt(g, to) + first);
        context.lineTo(columnAt(g, x + 1) + middle, rowAt(g, from));
      },
    );
  context.stroke();
  context.setLineDash(solid);
}

/** Those within the border. */
function paintClosed({ context, g, track, past }: Brush, known: boolean) {
  const isOne = (wall: number) => track.closed[wall] !== 0 && knows(past, wall) === known;
  const back = Math.floor(g.wall / 2);
  for (let y = 0; y + 1 < g.height; ++y)
    eachRun(
      g.width,
      (x) => isOne(y * g.width + x),
      (from, to) =>
        context.fillRect(columnAt(g, from) - back, rowAt(g, y + 1) - back, (to - from) * g.pitch + g.wall, g.wall),
    );
  for (let x = 0; x + 1 < g.width; ++x)
    eachRun(
      g.height,
      (y) => isOne(track.cells + y * g.width + x),
      (from, to) =>
        context.fillRect(columnAt(g, x + 1) - back, rowAt(g, to) - back, g.wall, (to - from) * g.pitch + g.wall),
    );
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

/** Walls that it takes for what they are not: a full one where there is none, a broken one where it believes in none. */
function paintMistaken({ context, g, palette, track, past }: Brush) {
  const { pattern } = dashesOf(g.pitch);
  const middle = (g.wall % 2) / 2;
  context.lineCap = 'butt';
  context.lineWidth = g.wall;
  context.strokeStyle = palette.wrong;
  for (const { wall, closed, from, to } of track.play.mistaken ?? []) {
    if (past.frame < from || (to !== null && past.frame >= to)) continue;
    context.fillStyle = closed ? palette.wrong : palette.paper;
    fillWall(context, g, wall);
    if (closed) continue;
    const [x, y] = [wall % g.width, Math.floor((wall % track.cells) / g.width)];
    context.setLineDash(pattern);
    context.beginPath();
    if (wall < track.cells) {
      context.moveTo(columnAt(g, x), rowAt(g, y + 1) + middle);
      context.lineTo(columnAt(g, x + 1), rowAt(g, y + 1) + middle);
    } else {
      context.moveTo(columnAt(g, x + 1) + middle, rowAt(g, y + 1));
      context.lineTo(columnAt(g, x + 1) + middle, rowAt(g, y));
    }
    context.stroke();
    context.setLineDash(solid);
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
  paintMistaken(brush);
  paintBorder(brush);
  if (draws && (layers.mms || !whole)) paintDrawn(brush);
}
