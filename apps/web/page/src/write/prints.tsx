// What a program printed, step by step, beside the replay of its contest.
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Print } from './contest';

interface Props {
  prints: Print[];
  /** What was printed last at the time of the replay; -1 for nothing. */
  marked: number;
  /** Leads the replay to a frame. */
  go(frame: number): void;
}

export const markedAt = (prints: Print[], time: number) => prints.filter(({ frame }) => frame <= time).length - 1;

export function Prints({ prints, marked, go }: Props) {
  const list = useRef<HTMLOListElement>(null);
  useLayoutEffect(() => {
    const now = list.current!.children[marked] as HTMLElement | undefined;
    if (now) list.current!.scrollTop = now.offsetTop - list.current!.offsetTop - list.current!.clientHeight / 2;
  }, [prints, marked]);
  return (
    <section class="prints" aria-label="Prints" hidden={prints.length === 0}>
      <h3>Prints</h3>
      <ol tabIndex={0} aria-label="What it printed, by step" ref={list}>
        {prints.map(({ frame, text }, i) => (
          <li aria-current={i === marked ? 'step' : undefined}>
            <button type="button" onClick={() => go(frame)}>
              step {frame + 1}
            </button>
            <pre>{text.replace(/\n$/, '')}</pre>
          </li>
        ))}
      </ol>
    </section>
  );
}
