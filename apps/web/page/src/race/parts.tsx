// What the parts of the view of a race have in common.
import type { ComponentChildren } from 'preact';
import type { RaceResults } from '../core/types';
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

interface PartProps {
  title: string;
  about?: string;
  children?: ComponentChildren;
}

/** A part of the view under its title. */
export const Part = ({ title, about, children }: PartProps) => (
  <section class="part" aria-label={title}>
    <h2>{title}</h2>
    {about && <p class="note">{about}</p>}
    {children}
  </section>
);
