// What stands behind the # of the page's address: a view, after an & whatever that view adds, or a maze or a program in a link.

export const viewNames = ['race', 'replay', 'live', 'draw', 'write', 'robot'] as const;
/** The home page has no place among them: the name of the page leads there. */
export type ViewName = (typeof viewNames)[number] | 'home';

/** `more`: whether the address says more than the view's name. */
export type Route = { view: ViewName; more: boolean } | { link: string } | { program: string };

/** Where that hash leads; null where it means nothing. */
export function routeOf(hash: string): Route | null {
  const text = hash.replace(/^#/, '');
  if (text.startsWith('maze=')) return { link: text.slice('maze='.length) };
  if (text.startsWith('write=')) return { program: text.slice('write='.length) };
  const view = [...viewNames, 'home' as const].find((name) => name === text.split('&', 1)[0]);
  return view ? { view, more: text.length > view.length } : null;
}

export const titleOf = (view: ViewName) => view[0].toUpperCase() + view.slice(1);
