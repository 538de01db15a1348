// What is wanted now and then, behind three dots: what the browser keeps, and on narrow screens all tools of the header.
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { Button, Check } from '../ui/controls';
import type { Notices } from './notices';
import type { Shelf } from '../page/shelf';

/** As the style sheet has it. */
const narrow = matchMedia('(max-width: 40rem)');

function useNarrow(): boolean {
  const [is, set] = useState(narrow.matches);
  useLayoutEffect(() => {
    const listen = () => set(narrow.matches);
    narrow.addEventListener('change', listen);
    return () => narrow.removeEventListener('change', listen);
  }, []);
  return is;
}

interface Props {
  /** Stand beside the dots where there is room for them. */
  children: ComponentChildren;
  shelf: Shelf;
  notices: Notices;
}

export function Menu({ children, shelf, notices }: Props) {
  const isNarrow = useNarrow();
  const menu = useRef<HTMLDetailsElement>(null);
  const [keeps, setKeeps] = useState(shelf.keeps());
  const close = () => void (menu.current!.open = false);
  useLayoutEffect(() => {
    document.addEventListener('pointerdown', ({ target }) => {
      if (target instanceof Node && !menu.current!.contains(target)) close();
    });
  }, []);
  async function keep(is: boolean) {
    setKeeps(is);
    await shelf.setKeeps(is);
    notices.tell(is ? 'What is open is kept from now on.' : 'Nothing is kept any more, and what was is gone.');
  }
  async function empty() {
    await shelf.empty();
    notices.tell('What was kept is gone.');
    close();
  }
  function escape(event: KeyboardEvent) {
    if (event.key !== 'Escape' || !menu.current!.open) return;
    close();
    menu.current!.querySelector('summary')?.focus();
    event.stopPropagation();
  }
  // What was chosen in it is done; a choice that stays open is not.
  const chosen = ({ target }: Event) => target instanceof Element && target.closest('button') && close();
  return (
    <div class="tools">
      {!isNarrow && children}
      <details class="menu" ref={menu} onKeyDown={escape}>
        <summary aria-label="More" title="More">
          <span aria-hidden="true">⋯</span>
        </summary>
        <div class="menu-box">
          <div class="menu-tools" onClick={chosen}>
            {isNarrow && children}
          </div>
          <Check label="Keep what is open for the next time" checked={keeps} change={(is) => void keep(is)} />
          <p class="note">In this browser alone: mazes, records, results, robots, programs and the drawing.</p>
          <Button label="Forget what was kept" act={empty} />
        </div>
      </details>
    </div>
  );
}
