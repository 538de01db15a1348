// Trees of Preact and elements that are put together by hand, one in the other.
import { render, type VNode } from 'preact';

/** The element of a tree that does not change. */
export function elementOf<Made extends Element>(tree: VNode): Made {
  const room = document.createDocumentFragment();
  render(tree, room);
  return room.firstElementChild as Made;
}

/** An element that stays in its place in a tree, whatever is drawn around it. */
export const Standing = ({ element }: { element: HTMLElement }) => (
  <div
    class="standing"
    ref={(place) => void (place && place.firstChild !== element && place.replaceChildren(element))}
  />
);
