// A mouse of ours beside the contest that is shown, under its conditions.
import { useRef, useState } from 'preact/hooks';
import type { Play } from '../core/types';
import { Button, Select } from '../ui/controls';
import type { Page } from '../page/page';
import type { Shown } from '../player/side';

interface Props {
  page: Page;
  /** What is shown now; nothing is offered beside two. */
  plays: Shown[];
  /** Hears of both plays. */
  shown(plays: Shown[]): void;
}

const usual = 'ariadne';

/** The same contest held by that mouse. */
const holdAgain = (page: Page, { maze, seed, again }: Play, mouse: string): Promise<Shown> =>
  page.core.call('contest', { ...again!.with, mouse, maze, seed: seed ?? 1 });

export function Beside({ page, plays, shown }: Props) {
  const [picked, pick] = useState(usual);
  const [busy, setBusy] = useState(false);
  const [first] = plays;
  const now = useRef(first);
  now.current = first;
  const mice = (plays.length === 1 && first.play.again?.mice) || [];
  const mouse = mice.includes(picked) ? picked : mice[0];
  async function play() {
    setBusy(true);
    try {
      const other = await holdAgain(page, first.play, mouse);
      if (first === now.current) shown([first, other]);
    } catch (error) {
      page.complain(error);
    } finally {
      setBusy(false);
    }
  }
  return (
    <p class="beside row" hidden={mice.length === 0}>
      <label>
        Beside it: <Select options={mice} value={mouse} choose={pick} />
      </label>
      <Button label="Play it" disabled={busy} act={play} />
    </p>
  );
}
