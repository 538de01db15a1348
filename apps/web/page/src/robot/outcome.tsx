// What follows from the robot: whether it can be, and its turns, straights and searches.
import type { ComponentChildren } from 'preact';
import type { RobotAnswer, RobotResult, RobotSentence } from '../core/types';
import { Meanings } from '../ui/meanings';
import { turnMeanings } from '../ui/terms';
import { Tables, Turns } from './figures';

/** After so many milliseconds the page says that it is at work. */
const patience = 100;

export type Outcome = ReturnType<typeof createOutcome>;

/** `draw` is called where the core is at work for long; all else is drawn by who changes it. */
export function createOutcome(draw: () => void) {
  const state = {
    words: '',
    kind: undefined as 'good' | 'fair' | 'bad' | undefined,
    refused: '',
    isBusy: false,
    /** Without a field of their own. */
    sentences: [] as RobotSentence[],
    /** The last robot that could be, and what it began from; null where that is the same. */
    result: null as RobotResult | null,
    before: null as RobotResult | null,
  };
  let late: ReturnType<typeof setTimeout> | undefined;
  return {
    state,
    /** Says after a moment that the core is at work. */
    wait() {
      clearTimeout(late);
      late = setTimeout(() => {
        Object.assign(state, { isBusy: true, words: 'Computing …', kind: 'fair' });
        draw();
      }, patience);
    },
    rest() {
      clearTimeout(late);
      state.isBusy = false;
    },
    show({ result, remarks, problems }: RobotAnswer, before: RobotAnswer | null, sentences: RobotSentence[]) {
      const refused = result ? '' : `Refused: ${problems[0]?.text ?? 'no robot'}`;
      const kind = result === null ? 'bad' : remarks.length > 0 ? 'fair' : 'good';
      Object.assign(state, { refused, sentences, words: result?.line ?? refused, kind });
      // What is shown below stays that of the last robot that could be.
      if (result) Object.assign(state, { result, before: before?.result ?? null });
    },
  };
}

/** Stays in sight while the form scrolls. */
export const Refusal = ({ outcome: { state } }: { outcome: Outcome }) => (
  <p class="refusal" role="alert">
    {state.refused}
  </p>
);

/** The best route stands among what follows. */
export function OutcomeRoom({ outcome: { state }, children }: { outcome: Outcome; children: ComponentChildren }) {
  const { words, kind, sentences, result, before } = state;
  return (
    <div class="desk-main">
      <p class="verdict" role="status" data-state={kind}>
        {words}
      </p>
      <ul class="robot-sentences" hidden={sentences.length === 0}>
        {sentences.map(({ text }) => (
          <li>{text}</li>
        ))}
      </ul>
      <div class="robot-follows">
        {children}
        <h3>Turns</h3>
        {result && <Turns result={result} before={before} />}
        <Meanings of={turnMeanings} />
        <h3>Straights and the search</h3>
        {result && <Tables result={result} before={before} />}
      </div>
    </div>
  );
}
