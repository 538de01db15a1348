// What the parts of the view of a race have in common.
import type { RaceResults } from '../core/types';
import { h } from '../ui/dom';
import { groupsOf } from '../results/contests';
import { counted, isNumber } from '../ui/format';

/** What the race was, in one line. */
export function facts(results: RaceResults): string {
  const { seed, labmouse, stopped, skipped } = results;
  const groups = groupsOf(results);
  const budget = groups.find((group) => isNumber(group.budget))?.budget;
  const mice = groups.flatMap((group) => group.mice);
  const contests = mice.reduce((sum, mouse) => sum + mouse.results.length, 0);
  return [
    counted(mice.length, 'mouse', 'mice'),
    counted(Math.max(0, ...groups.map((group) => group.mazes.length)), 'maze'),
    counted(contests, 'contest'),
    `seed ${seed}`,
    isNumber(budget) && `budget ${budget} steps`,
    `labmouse ${labmouse}`,
    stopped && 'stopped early',
    skipped?.length > 0 && `${counted(skipped.length, 'file')} skipped`,
  ]
    .filter(Boolean)
    .join(' · ');
}

/** A part of the view under its title. */
export const part = (title: string, about: string, ...content: HTMLElement[]) =>
  h('section.part', { 'aria-label': title }, h('h2', title), about ? h('p.note', about) : null, ...content);
