// One view is shown at a time. Views come when the core has started; what was meant for them waits until then.
import type { View } from '../page/page';
import type { Frame } from './frame';
import { routeOf, type ViewName } from '../link/routes';
import { errorText } from '../ui/format';

/** Where a link leads, for the view that it names. */
export class Link {
  constructor(readonly hash: string) {}
}

export type Stage = ReturnType<typeof createStage>;

/** A view that fails over a strange file must not take the page with it. */
function safely(act: () => void, complain: (message: string) => void) {
  try {
    act();
  } catch (error) {
    complain(`This could not be shown: ${errorText(error)}`);
  }
}

/** The address names the view, and no longer what a link led to. */
function nameInAddress(name: ViewName) {
  const route = routeOf(location.hash);
  if (!route || !('view' in route) || route.view !== name) location.hash = name;
  else if (route.more) history.replaceState(null, '', `#${name}`);
}

export function createStage(frame: Frame, complain: (error: unknown) => void) {
  const views = new Map<ViewName, View>();
  const things = new Map<ViewName, unknown>();
  const given = new Set<ViewName>();
  const set = (name: ViewName, thing: unknown) => (given.add(name), things.set(name, thing));
  /** How far down each view was when it was left. */
  const places = new Map<ViewName, number>();
  let current: ViewName | null = null;
  // The browser keeps one place for the whole page and an entry of the way back, which is not the same.
  history.scrollRestoration = 'manual';

  function give(name: ViewName) {
    const view = views.get(name);
    if (!view) return;
    const thing = things.get(name);
    things.delete(name);
    if (thing !== undefined && !(thing instanceof Link)) safely(() => view.accept?.(thing), complain);
    if (current === name) safely(() => view.shown(), complain);
    if (thing instanceof Link) view.follow?.(thing.hash).catch(complain);
  }
  return {
    add(name: ViewName, view: View) {
      views.set(name, view);
      view.element.hidden = current !== name;
      frame.main.append(view.element);
      frame.setStarting(current !== null && !views.has(current));
      give(name);
    },
    /** Shows that view, with `thing` from its top; then the address names the view, unless it is to be kept. */
    show(name: ViewName, thing?: unknown, keepAddress = false) {
      if (thing !== undefined) set(name, thing);
      const top = things.has(name) ? 0 : (places.get(name) ?? 0);
      if (current !== null && current !== name) {
        places.set(current, scrollY);
        safely(() => views.get(current!)?.hidden?.(), complain);
      }
      current = name;
      for (const [other, view] of views) view.element.hidden = other !== name;
      frame.setStarting(!views.has(name));
      frame.mark(name);
      if (thing !== undefined && !keepAddress) nameInAddress(name);
      give(name);
      scrollTo({ top, behavior: 'instant' });
    },
    /** Keeps `thing` for when that view is shown next. */
    keep: (name: ViewName, thing: unknown) => void set(name, thing),
    /** The same for a view that has been given nothing so far; where it is on stage it is shown at once. */
    offer(name: ViewName, thing: unknown) {
      if (given.has(name)) return;
      set(name, thing);
      if (current === name) give(name);
    },
    /** The view on stage. */
    current: () => current,
    view: (name: ViewName) => views.get(name),
  };
}
