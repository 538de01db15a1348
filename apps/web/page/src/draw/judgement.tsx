// What the core says about the drawing while it changes.
import type { Inspection, MazeData } from '../core/types';
import { Meanings } from '../ui/meanings';
import { boundMeaning, mmsBoundMeaning, optimumMeaning } from '../ui/terms';
import { createLatest } from '../ui/latest';
import type { Page } from '../page/page';
import { counted, errorText, number } from '../ui/format';

/** After so many milliseconds without an answer, the last one is taken back: it speaks of another drawing. */
const patience = 200;

const countOf = (value: number | null, one: string) => (value === null ? '–' : counted(value, one));
const arrives = (value: boolean) => (value ? 'arrives' : 'does not arrive');

/** The figures, each with what it means. */
function figures(found: Inspection, cells: number): [string, string, string][] {
  return [
    ['Shortest run', countOf(found.optimum, 'step'), optimumMeaning],
    ['Best possible', number(found.bound, 3), boundMeaning],
    ['Best in mms', number(found.mms_score, 3), mmsBoundMeaning],
    ['Shortest path', countOf(found.shortest_cells, 'cell'), 'from the start to the nearest goal'],
    ['Reachable', `${found.reachable} of ${cells} cells`, 'from the start'],
    ['Dead ends', number(found.dead_ends, 0), 'cells with only one way in'],
    ['Junctions', number(found.junctions, 0), 'cells with three or four ways'],
    ['Loops', number(found.loops, 0), 'walls that could be closed without cutting off any cell'],
    ['Left hand', arrives(found.left_follower_arrives), 'a mouse with its left hand on the wall'],
    ['Right hand', arrives(found.right_follower_arrives), 'a mouse with its right hand on the wall'],
  ];
}

/** The most important thing about a drawing. */
function verdict(found: Inspection): { words: string; kind: 'good' | 'fair' | 'bad' } {
  if (found.optimum === null) return { words: 'No goal can be reached from the start.', kind: 'bad' };
  const broken = found.contest_rules.filter((rule) => !rule.passed).length;
  const all = found.contest_rules.length;
  if (broken === 0) return { words: `A contest maze: it follows all ${all} rules.`, kind: 'good' };
  return { words: `The goal can be reached; ${broken} of ${all} contest rules are broken.`, kind: 'fair' };
}

/** Rules that forbid something say so, or they seem to contradict the figures. */
const ruleInWords = (name: string) => (name.endsWith('wall follower') ? `${name} must not arrive` : name);

export type Judgement = ReturnType<typeof createJudgement>;

/** `route` hears of the shortest run of the drawing, and of null while it is not known; then the view is drawn. */
export function createJudgement(page: Page, route: (found: Inspection | null) => void) {
  const state = {
    words: '',
    kind: undefined as 'good' | 'fair' | 'bad' | undefined,
    isStale: false,
    /** What the core said last. */
    found: null as Inspection | null,
    cells: 0,
  };
  let late: ReturnType<typeof setTimeout> | undefined;

  function tell(changes: Partial<typeof state>, now: Inspection | null) {
    clearTimeout(late);
    late = undefined;
    Object.assign(state, changes);
    route(now);
  }
  const latest = createLatest(
    (maze: MazeData) => page.core.call('inspect', { maze }),
    (found, { width, height }) => tell({ ...verdict(found), isStale: false, found, cells: width * height }, found),
    (error) => tell({ words: errorText(error), kind: 'bad' }, null),
  );
  return {
    state,
    judge(maze: MazeData) {
      late ??= setTimeout(() => {
        state.isStale = true;
        route(null);
      }, patience);
      latest.ask(maze);
    },
  };
}

const Rules = ({ found }: { found: Inspection }) => (
  <ul class="rules">
    {found.contest_rules.map(({ name, passed, reason }) => (
      <li>
        <span class={passed ? 'rule-mark kept' : 'rule-mark broken'}>{passed ? '✓ kept' : '✗ broken'}</span>
        <span class="rule-name">{ruleInWords(name)}</span>
        {reason && <p>{reason}</p>}
      </li>
    ))}
  </ul>
);

export function JudgementCard({ judgement: { state } }: { judgement: Judgement }) {
  const { words, kind, isStale, found, cells } = state;
  const all = found ? figures(found, cells) : [];
  return (
    <section class={isStale ? 'card stale' : 'card'} aria-label="Judgement">
      <h2>Judgement</h2>
      <p class="verdict" role="status" data-state={kind}>
        {words}
      </p>
      <dl class="figures">
        {all.map(([name, value, meaning]) => (
          <div title={meaning}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <div>{found && <Meanings of={all.map(([name, , meaning]) => [name, meaning])} />}</div>
      <details open>
        <summary>Contest rules</summary>
        {found && <Rules found={found} />}
      </details>
    </section>
  );
}
