// What the terms of a list or a table mean, to be read where they stand: a title needs a pointer.
import { elementOf } from './element';

interface Props {
  /** Terms with their meanings; those without one are left out. */
  of: [term: string, meaning: string | undefined][];
}

/** Folded away. */
export const Meanings = ({ of }: Props) => (
  <details class="meanings controls">
    <summary>What they mean</summary>
    <dl>
      {of.map(
        ([term, meaning]) =>
          meaning && (
            <>
              <dt>{term}</dt>
              <dd>{meaning}</dd>
            </>
          ),
      )}
    </dl>
  </details>
);

export const meanings = (of: Props['of']): HTMLElement => elementOf(<Meanings of={of} />);
