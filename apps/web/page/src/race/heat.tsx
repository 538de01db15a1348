// Where the mice of a race lose their steps in one maze, all of them together. The core says what is lost.
import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { Losses, MazeData } from '../core/types';
import { cellAt, fit, numbered, type Geometry } from '../maze/geometry';
import { fontOf } from '../maze/fonts';
import type { Context } from '../maze/painter';
import { readPalette, type Palette } from '../maze/palette';
import { savePicture, type Picture } from '../maze/saved';
import { createStage, StageRoom } from '../maze/stage';
import { Button, Select } from '../ui/controls';
import type { EarlyPage } from '../page/page';
import type { LoadedRace } from '../results/loaded';
import type { Board } from '../results/contests';
import { counted, isNumber } from '../ui/format';
import { levelEnd, levels, paintLosses } from './heat-paint';
import { isOurs } from './contest-play';

/** What a cell is coloured by: all that is lost of the score, or the steps of one of the runs. */
const kinds = {
  points: { label: 'of the score', unit: 'points' },
  search: { label: 'steps of the search run', unit: 'steps' },
  speed: { label: 'steps of the speed run', unit: 'steps' },
} as const;
type Kind = keyof typeof kinds;

const most = 5_000;
/** So many cells are listed in words. */
const told = 5;
/** Of a saved picture, in its pixels. */
const side = 1200;
const line = 44;

/** What the mean contest loses in each cell. */
const lossesOf = (found: Losses, kind: Kind): number[] =>
  kind === 'points' ? found.points : found[kind].map((steps) => steps / Math.max(1, found.finished));

const placeOf = (cell: number, maze: MazeData) => `(${cell % maze.width},${Math.floor(cell / maze.width)})`;
const amount = (loss: number, kind: Kind) => `${loss.toFixed(2)} ${kinds[kind].unit}`;

interface Shown {
  maze: MazeData;
  found: Losses;
  title: string;
}

/** Those contests of that maze which the page can run again, and how many mice it cannot. */
async function contestsIn(page: EarlyPage, board: Board, maze: number) {
  const contests: { mouse: string; seed: number }[] = [];
  let others = 0;
  for (const { name, index, reference } of board.mice) {
    if (reference) continue;
    const ours = await isOurs(page, name);
    if (!ours) ++others;
    else
      for (const { seed } of board.cells[index][maze].contests) if (seed !== null) contests.push({ mouse: name, seed });
  }
  return { contests: contests.slice(0, most), others };
}

function Scale({ losses, kind }: { losses: number[]; kind: Kind }) {
  const highest = Math.max(...losses);
  return (
    <div class="scale">
      <span>lost in a cell by the mean contest, {kinds[kind].unit}:</span>
      <ul>
        {Array.from({ length: levels }, (_, i) => (
          <li>
            <span class={`swatch heat${i + 1}`} />
            to {levelEnd(i + 1, highest).toFixed(2)}
          </li>
        ))}
      </ul>
    </div>
  );
}

/** The picture with its title and its scale, on any kind of canvas. */
function paintSaved(
  context: Context,
  g: Geometry,
  palette: Palette,
  { maze, title }: Shown,
  losses: number[],
  scale: string,
) {
  paintLosses(context, g, palette, maze, losses);
  context.fillStyle = palette.paper;
  context.fillRect(0, g.canvasHeight - 2 * line, g.canvasWidth, 2 * line);
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillStyle = palette.ink;
  context.font = fontOf(palette, 24, 600);
  context.fillText(title, line, g.canvasHeight - line);
  context.font = fontOf(palette, 20);
  context.fillText(scale, line, g.canvasHeight - line / 3);
}

/** The same for a file. */
function pictureOf(shown: Shown, losses: number[], kind: Kind): Picture {
  const palette = readPalette();
  const fitted = fit(shown.maze, side, side, 2, numbered);
  const g = { ...fitted, canvasHeight: fitted.canvasHeight + 2 * line };
  const scale = `Darkest: ${amount(Math.max(...losses), kind)} of the mean contest in one cell`;
  return { g, paint: (context) => paintSaved(context, g, palette, shown, losses, scale) };
}

/** What the mean contest loses, and where most of it. */
function lossWords({ maze, found }: Shown, losses: number[], kind: Kind): string {
  const worst = losses
    .map((loss, cell) => ({ loss, cell }))
    .filter(({ loss }) => loss > 0)
    .sort((a, b) => b.loss - a.loss)
    .slice(0, told);
  const where = worst.map(({ loss, cell }) => `${placeOf(cell, maze)} ${amount(loss, kind)}`).join(', ');
  const sum = losses.reduce((all, loss) => all + loss, 0);
  const failed = found.contests - found.finished;
  const without = failed > 0 ? ` ${counted(failed, 'contest')} without a score left out.` : '';
  if (sum <= 0) return `Nothing is lost here.${without}`;
  return `The mean contest loses ${amount(sum, kind)}, most of it in ${where}.${without}`;
}

/** The losses on a stage, in words, and as files. */
function HeatMap({ page, shown }: { page: EarlyPage; shown: Shown }) {
  const { maze } = shown;
  const [kind, choose] = useState<Kind>('points');
  const [pointed, point] = useState('Point at a cell to see what is lost in it.');
  const losses = lossesOf(shown.found, kind);
  const latest = useRef(losses);
  latest.current = losses;
  const words = lossWords(shown, losses, kind);
  const stage = useMemo(
    () =>
      createStage(maze, (context, g, palette) => paintLosses(context, g, palette, maze, latest.current), {
        numbers: true,
      }),
    [],
  );
  useLayoutEffect(() => {
    stage.describe(`${shown.title}. ${words}`);
    stage.redraw();
  }, [kind]);
  function read({ offsetX, offsetY }: PointerEvent) {
    const cell = cellAt(stage.geometry(), offsetX, offsetY);
    if (cell) point(`(${cell[0]},${cell[1]}): ${amount(losses[cell[1] * maze.width + cell[0]], kind)}`);
  }
  const save = (ending: 'png' | 'svg') =>
    savePicture(page.save, 'lost-steps', ending, pictureOf(shown, losses, kind)).catch(page.complain);
  return (
    <div>
      <div class="row controls">
        <label class="row">
          Show what is lost
          <Select
            options={Object.entries(kinds).map(([value, { label }]) => [value, label])}
            value={kind}
            choose={(kind) => choose(kind as Kind)}
          />
        </label>
        <Button label="Save as PNG" act={() => save('png')} />
        <Button label="Save as SVG" act={() => save('svg')} />
      </div>
      <p class="words" aria-live="polite">
        {words}
      </p>
      <div class="heat-room">
        <StageRoom stage={stage} onPointerMove={read} />
      </div>
      <p class="caption">{pointed}</p>
      <Scale losses={losses} kind={kind} />
    </div>
  );
}

/** Runs the contests in that maze again, and says what they lose where. */
async function findLosses(page: EarlyPage, race: LoadedRace, board: Board, at: number): Promise<Shown> {
  const { name, short } = board.mazes[at];
  const maze = await race.maze(name);
  if (!maze) throw new Error(`The maze ${short} is not in this page. Drop its file here, then try again.`);
  const { contests, others } = await contestsIn(page, board, at);
  if (contests.length === 0) throw new Error(`The page can run none of the contests in ${short} again.`);
  const { budget } = board.conditions;
  const found = await page.core.call('losses', { maze, contests, ...(isNumber(budget) && { budget }) });
  const without = others > 0 ? `, without ${counted(others, 'mouse', 'mice')} of other programs` : '';
  const mice = counted(new Set(contests.map(({ mouse }) => mouse)).size, 'mouse', 'mice');
  const title = `Where steps are lost in ${short}: ${mice}, ${counted(found.contests, 'contest')}${without}`;
  return { maze, found, title };
}

export function Heat({ page, race, board }: { page: EarlyPage; race: LoadedRace; board: Board }) {
  const [maze, choose] = useState(0);
  const [isBusy, setBusy] = useState(false);
  const [shown, show] = useState<Shown | null>(null);
  async function find() {
    setBusy(true);
    try {
      show(await findLosses(page, race, board, maze));
    } catch (error) {
      page.complain(error);
    } finally {
      setBusy(false);
    }
  }
  return (
    <div class="heat">
      <div class="row controls">
        <label class="row">
          Maze
          <Select
            options={board.mazes.map(({ short, index }) => [index, short])}
            value={maze}
            choose={(index) => choose(Number(index))}
          />
        </label>
        <Button label="Show where" disabled={isBusy} act={find} />
      </div>
      {shown && <HeatMap key={shown} page={page} shown={shown} />}
    </div>
  );
}
