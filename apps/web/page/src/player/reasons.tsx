// Why the mouse went where it went: what it weighed in its last choice, as a table and in words.
import { useState } from 'preact/hooks';
import type { Candidate, Reasons as Choice } from '../core/types';
import { counted, short } from './figures';
import type { PanelProps } from './state';

const rowsAtFirst = 6;

const caption =
  'All in steps. Through: the speed run through that wall, as far as the mouse considers it; travel: the way to the ' +
  'cell from which it can be seen; score: the value compared, the lowest wins. – not worth the way';

const nameOf = ({ wall, seen_from: [x, y] }: Candidate) =>
  wall ? `(${wall[0]},${wall[1]}) ${wall[2]}` : `goal (${x},${y})`;

/** Candidates: the chosen one first, then those worth the way, the lowest score first. */
function ranked({ candidates, chosen }: Choice): Candidate[] {
  const first = (a: boolean, b: boolean) => Number(b) - Number(a);
  return [...candidates].sort(
    (a, b) => first(a === candidates[chosen], b === candidates[chosen]) || first(a.worth, b.worth) || a.score - b.score,
  );
}

/** In words, where no wall was chosen. */
function verdict({ chosen, known, hope, price, candidates }: Choice): string {
  const run = known > 0 ? `The best known run takes ${short(known)} steps.` : 'No run is known yet.';
  if (chosen >= 0) return known > 0 ? run : '';
  if (candidates.length === 0) return `${run} No unseen wall is left that a better run could pass.`;
  if (hope <= 0) return run;
  return `${run} The best hope is one of ${short(hope)}; looking at it costs ${short(price)}. Not worth it.`;
}

const titleOf = ({ frame, ground, candidates }: Choice) =>
  `Before step ${frame + 1}: ${ground || counted(candidates.length, 'candidate')}`;

function Line({ candidate, chosen }: { candidate: Candidate; chosen: boolean }) {
  const { worth, seen_from: from, through, travel, score } = candidate;
  return (
    <tr class={chosen ? 'chosen' : worth ? '' : 'unworthy'}>
      <th scope="row">
        {chosen ? '▸ ' : worth ? '' : '– '}
        {nameOf(candidate)}
      </th>
      <td>
        ({from[0]},{from[1]})
      </td>
      <td>{through.toFixed(2)}</td>
      <td>{short(travel)}</td>
      <td>{score.toFixed(2)}</td>
    </tr>
  );
}

function Candidates({ choice }: { choice: Choice }) {
  const [everything, setEverything] = useState(false);
  const order = ranked(choice);
  return (
    <>
      <div class="wide" role="region" tabIndex={0} aria-label="Candidates">
        <table>
          <caption>{caption}</caption>
          <thead>
            <tr>
              {['wall', 'seen from', 'through', 'travel', 'score'].map((name) => (
                <th scope="col">{name}</th>
              ))}
            </tr>
          </thead>
          <tbody>
            {order.slice(0, everything ? order.length : rowsAtFirst).map((one) => (
              <Line candidate={one} chosen={one === choice.candidates[choice.chosen]} />
            ))}
          </tbody>
        </table>
      </div>
      {order.length > rowsAtFirst && (
        <button type="button" class="quiet" onClick={() => setEverything(!everything)}>
          {everything ? 'fewer' : `and ${order.length - rowsAtFirst} more`}
        </button>
      )}
    </>
  );
}

export function Reasons({ state }: PanelProps) {
  const { track, scene } = state.sides[state.chosen];
  if (track.play.reasons.length === 0) return null;
  const choice = track.play.reasons[track.reasons[scene.past.frame]];
  return (
    <section class="reasons">
      <h3>Reasons</h3>
      <p class="choice">{choice ? titleOf(choice) : 'No choice yet.'}</p>
      <p class="note">{choice && verdict(choice)}</p>
      {choice && choice.candidates.length > 0 && <Candidates choice={choice} />}
    </section>
  );
}
