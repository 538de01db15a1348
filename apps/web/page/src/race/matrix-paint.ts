// The matrix on its canvas, in whole device pixels.
import { fitting } from '../ui/fitting';
import { tone } from '../ui/tones';
import type { Board, Cell } from '../results/contests';
import type { Layout } from './matrix-layout';
import { steps, toneName, toneOf } from './scale';

export interface MatrixPicture {
  board: Board;
  mice: number[];
  mazes: number[];
  layout: Layout;
}

type Box = [x: number, y: number, width: number, height: number];

/** A cross in the middle: all contests failed. */
function cross(context: CanvasRenderingContext2D, [x, y, width, height]: Box, ratio: number) {
  const size = Math.max(2.5 * ratio, Math.min(width, height) * 0.55);
  const [left, top] = [x + (width - size) / 2, y + (height - size) / 2];
  context.beginPath();
  context.moveTo(left, top);
  context.lineTo(left + size, top + size);
  context.moveTo(left + size, top);
  context.lineTo(left, top + size);
  context.stroke();
}

/** A filled corner: some of the contests failed. */
function corner(context: CanvasRenderingContext2D, [x, y, width, height]: Box, ratio: number) {
  const size = Math.min(width, height, 7 * ratio);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + size, y);
  context.lineTo(x, y + size);
  context.fill();
}

/** A line in the middle: no contest, or no way to the goal. */
function dash(context: CanvasRenderingContext2D, [x, y, width, height]: Box, ratio: number) {
  const length = Math.min(width * 0.6, 8 * ratio);
  context.fillRect(x + (width - length) / 2, y + Math.round(height / 2), length, Math.max(1, Math.round(ratio)));
}

function names(context: CanvasRenderingContext2D, { board, mazes, layout }: MatrixPicture, ratio: number) {
  if (layout.top < 20) return;
  context.font = `${11 * ratio}px ${getComputedStyle(document.documentElement).fontFamily}`;
  context.fillStyle = tone('muted');
  context.textBaseline = 'middle';
  mazes.forEach((maze, column) => {
    context.save();
    context.translate((column + 0.5) * layout.cellWidth * ratio, (layout.top - 4) * ratio);
    context.rotate(-Math.PI / 2);
    context.fillText(fitting(context, board.mazes[maze].short, (layout.top - 8) * ratio), 0, 0);
    context.restore();
  });
}

/** Paints all cells anew. */
export function paintMatrix(canvas: HTMLCanvasElement, picture: MatrixPicture) {
  const { board, mice, mazes, layout } = picture;
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.max(1, Math.round(layout.width * ratio));
  canvas.height = Math.max(1, Math.round(layout.height * ratio));
  canvas.style.width = `${layout.width}px`;
  canvas.style.height = `${layout.height}px`;
  const context = canvas.getContext('2d');
  if (!context) return;
  const tones = Array.from({ length: steps.length + 1 }, (_, step) => tone(toneName(step)));
  const [ink, muted, paper] = [tone('ink'), tone('muted'), tone('paper')];
  const edge = (place: number, size: number) => Math.round(place * size * ratio);
  const top = Math.round(layout.top * ratio);
  const gap = layout.cellWidth >= 6 ? Math.max(1, Math.round(ratio)) : 0;

  function paintCell(cell: Cell, maze: number, box: Box) {
    if (cell.contests.length === 0 || board.mazes[maze].bound === null) {
      context!.fillStyle = muted;
      return dash(context!, box, ratio);
    }
    if (cell.finished === 0) {
      context!.strokeStyle = ink;
      return cross(context!, box, ratio);
    }
    const step = toneOf(cell.ratio ?? 1);
    context!.fillStyle = tones[step];
    context!.fillRect(...box);
    if (cell.finished === cell.contests.length) return;
    context!.fillStyle = step > 3 ? paper : ink;
    corner(context!, box, ratio);
  }

  context.lineWidth = Math.max(1, ratio * 1.25);
  mice.forEach((mouse, row) =>
    mazes.forEach((maze, column) => {
      const [x, y] = [edge(column, layout.cellWidth), top + edge(row, layout.cellHeight)];
      const width = edge(column + 1, layout.cellWidth) - x - gap;
      paintCell(board.cells[mouse][maze], maze, [
        x,
        y,
        width,
        top + edge(row + 1, layout.cellHeight) - y - Math.max(1, Math.round(ratio)),
      ]);
    }),
  );
  names(context, picture, ratio);
}
