// What the programs had to say at the end.
import type { PanelProps } from './state';

export function LastWords({ state }: PanelProps) {
  const speaking = state.sides.filter(({ track }) => track.play.last_words !== '');
  return (
    <section class="words" hidden={speaking.length === 0}>
      <h3>Last words</h3>
      {speaking.map(({ track: { play } }) => (
        <div>
          <p class="note">{play.mouse}</p>
          <pre tabIndex={0} role="region" aria-label={`Last words of ${play.mouse}`}>
            {play.last_words}
          </pre>
        </div>
      ))}
    </section>
  );
}
