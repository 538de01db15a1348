// The walk before the last change, to be seen beside the one after it.
import type { Play } from '../core/types';
import { nameOf } from '../link/my-robot';

/** What was run, and what came of it. */
export interface Walk {
  spec: string;
  seed: number;
  budget: number;
  drive?: { robot: string; rules: string } | null;
  play: Play;
  record: string;
}

const scoreOf = ({ score }: Play) => (score === null ? 'no score' : score.toFixed(3));

/** What was asked for differently: "certify → certify:home=yes, seed 1 → 2". */
function changes(before: Walk, now: Walk): string {
  const parts = [
    before.spec !== now.spec && `${before.spec} → ${now.spec}`,
    before.seed !== now.seed && `seed ${before.seed} → ${now.seed}`,
    before.drive?.robot !== now.drive?.robot &&
      `robot ${nameOf(before.drive?.robot ?? '')} → ${nameOf(now.drive?.robot ?? '')}`,
    before.drive?.rules !== now.drive?.rules && `rules ${before.drive?.rules} → ${now.drive?.rules}`,
    !now.drive && before.budget !== now.budget && `budget ${before.budget} → ${now.budget}`,
  ];
  return parts.filter(Boolean).join(', ');
}

function signed(difference: number) {
  const text = Math.abs(difference).toFixed(3);
  return Number(text) === 0 ? '±0' : `${difference < 0 ? '−' : '+'}${text}`;
}

/** What a change did to the score, in a line. */
export function comparisonInWords(before: Walk, now: Walk): string {
  const asked = changes(before, now);
  const isSameWalk =
    JSON.stringify([before.play.action, before.play.clock]) === JSON.stringify([now.play.action, now.play.clock]);
  const [was, is] = [before.play.score, now.play.score];
  const difference = was !== null && is !== null ? ` (${signed(is - was)}; lower is better)` : '';
  const score = `score ${scoreOf(before.play)} → ${scoreOf(now.play)}${difference}`;
  return `${asked}: ${isSameWalk ? `the same walk, score ${scoreOf(now.play)}` : score}`;
}
