// What the terms of a list or a table mean, to be read where they stand: a title needs a pointer.

interface Props {
  /** Terms with their meanings; those without one are left out. */
  of: [term: string, meaning: string | undefined][];
  title?: string;
  class?: string;
}

/** Folded away. */
export const Meanings = ({ of, title = 'What they mean', class: name = 'meanings' }: Props) => (
  <details class={`${name} controls`}>
    <summary>{title}</summary>
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
