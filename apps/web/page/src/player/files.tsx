// What can be done with the contests that are shown: saved, printed, opened elsewhere.
import { useRef, useState } from 'preact/hooks';
import { FilmStopped } from '../film/film';
import type { EarlyPage } from '../page/page';
import { fileName, filmOf, pngOf, svgOf } from './pictures';
import type { PanelProps } from './state';
import { Button } from '../ui/controls';

export function Files({ page, state }: Omit<PanelProps, 'actions'> & { page: EarlyPage }) {
  const chosen = state.sides[state.chosen];
  const { play, maze } = chosen.track;
  /** Of a film that is made: the share that is done; null while none is. */
  const [done, setDone] = useState<number | null>(null);
  const wanted = useRef(true);

  async function saveFilm() {
    const sides = [...state.sides];
    wanted.current = true;
    setDone(0);
    try {
      const { gif, words } = await filmOf(state, setDone, () => wanted.current);
      page.save(fileName(sides, 'gif'), gif, 'image/gif');
      page.tell(words);
    } catch (error) {
      if (!(error instanceof FilmStopped)) throw error;
      page.tell('The film was stopped.');
    } finally {
      setDone(null);
    }
  }
  async function savePicture() {
    const { svg } = await page.core.call('picture', {}, new TextEncoder().encode(chosen.record));
    page.save(fileName([chosen], 'svg'), svg, 'image/svg+xml');
  }
  const savePng = async () => page.save(fileName(state.sides, 'png'), await pngOf(state), 'image/png');
  const saveSvg = () => page.save(fileName(state.sides, 'svg'), svgOf(state), 'image/svg+xml');

  const button = (label: string, act: () => void | Promise<void>, title?: string, disabled = false) => (
    <Button
      label={label}
      title={title}
      disabled={disabled}
      act={() => void Promise.resolve(act()).catch(page.complain)}
    />
  );
  const unrecorded = chosen.record === '';
  return (
    <div class="files" role="group" aria-label="Save and open">
      {button('Save record', () => page.save(fileName([chosen], 'jsonl'), chosen.record), undefined, unrecorded)}
      {button('Save whole walk (SVG)', savePicture, undefined, unrecorded || !play.traits.pictured)}
      {button('Save moment (PNG)', savePng, 'What is on the stage now, in pixels')}
      {button('Save moment (SVG)', saveSvg, 'What is on the stage now, as a drawing')}
      {button('Save film (GIF)', saveFilm, 'The whole contest, as it is played', done !== null)}
      {button('Run in Live', () => page.live(maze))}
      {button('Open in Draw', () => page.draw(maze))}
      {button('Print', () => print())}
      {done !== null && (
        <div class="row filming">
          <progress max={1} value={done} aria-label="Progress of the film" />
          {button('Stop the film', () => void (wanted.current = false))}
        </div>
      )}
    </div>
  );
}
