// Keys that work all over a view, and those who need them for themselves.

/** Whether an element needs that key itself. */
export function needsKey(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement && (target.type === 'range' || target.type === 'checkbox'))
    return target.type === 'checkbox' ? key === ' ' : false;
  if (target.matches('input, select, textarea, [contenteditable]')) return true;
  return key === ' ' && target.closest('button, a, summary') !== null;
}
