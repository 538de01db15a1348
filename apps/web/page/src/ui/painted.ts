// What is painted or plotted for the room that it has, in the tones of the page.
import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { onTones } from './tones';

/** Calls `paint` after a drawing in which `deps` are others, and whenever the width of that element or the tones are. */
export function usePainted(element: RefObject<HTMLElement | null>, paint: () => void, deps: unknown[]) {
  const latest = useRef(paint);
  latest.current = paint;
  useLayoutEffect(() => latest.current(), deps);
  useLayoutEffect(() => {
    const room = element.current!;
    let width = room.clientWidth;
    const observer = new ResizeObserver(() => {
      if (room.clientWidth === width) return;
      width = room.clientWidth;
      latest.current();
    });
    observer.observe(room);
    const unwatch = onTones(() => latest.current());
    return () => {
      observer.disconnect();
      unwatch();
    };
  }, []);
}
