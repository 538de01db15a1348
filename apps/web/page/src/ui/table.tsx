// Tables of which nothing changes.
import type { ComponentChildren } from 'preact';

interface ScrollingProps {
  label: string;
  class?: string;
  hidden?: boolean;
  children: ComponentChildren;
}

/** A place for what may be wider than it; the keyboard scrolls it, too. */
export const Scrolling = ({ label, class: name = 'box', hidden, children }: ScrollingProps) => (
  <div class={name} tabIndex={0} role="region" aria-label={label} hidden={hidden}>
    {children}
  </div>
);

interface TableProps {
  label?: string;
  caption?: string;
  /** A head may have a title. */
  heads?: (string | [head: string, title: string])[];
  rows: ComponentChildren[][];
}

/** The first column names the rows. */
export const Table = ({ label, caption, heads = [], rows }: TableProps) => (
  <table aria-label={label}>
    {caption && <caption>{caption}</caption>}
    {heads.length > 0 && (
      <thead>
        <tr>
          {heads.map((head) => (
            <th scope="col" title={typeof head === 'string' ? undefined : head[1]}>
              {typeof head === 'string' ? head : head[0]}
            </th>
          ))}
        </tr>
      </thead>
    )}
    <tbody>
      {rows.map(([first, ...cells]) => (
        <tr>
          <th scope="row">{first}</th>
          {cells.map((cell) => (
            <td>{cell}</td>
          ))}
        </tr>
      ))}
    </tbody>
  </table>
);
