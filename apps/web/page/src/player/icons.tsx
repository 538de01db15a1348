// The signs on the player's buttons.

const lens = 'M10 3a7 7 0 1 0 0 14a7 7 0 1 0 0-14zM10 5a5 5 0 1 1 0 10a5 5 0 1 1 0-10zM15 16.4l1.4-1.4 5 5-1.4 1.4z';

const shapes = {
  play: 'M6 4l13 8-13 8z',
  pause: 'M6 4h4v16H6zM14 4h4v16h-4z',
  back: 'M17 4L7 12l10 8zM4 4h3v16H4z',
  forward: 'M7 4l10 8-10 8zM17 4h3v16h-3z',
  start: 'M20 4l-8 8 8 8zM12 4l-8 8 8 8zM2 4h2v16H2z',
  end: 'M4 4l8 8-8 8zM12 4l8 8-8 8zM20 4h2v16h-2z',
  nearer: `${lens}M9.2 7h1.6v2.2H13v1.6h-2.2V13H9.2v-2.2H7V9.2h2.2z`,
  farther: `${lens}M7 9.2h6v1.6H7z`,
  undo: 'M9 4L3 9l6 5v-4h5a4 4 0 0 1 0 8H7v2h7a6 6 0 0 0 0-12H9z',
  redo: 'M15 4l6 5-6 5v-4h-5a4 4 0 0 0 0 8h7v2h-7a6 6 0 0 1 0-12h5z',
  screen: 'M3 3h7v3H6v4H3zM14 3h7v7h-3V6h-4zM3 14h3v4h4v3H3zM18 14h3v7h-7v-3h4z',
  panel: 'M3 4h18v16H3zM5 6v12h8V6z',
  loop: 'M5 11a7 7 0 0 1 12-4l-2 2h6V3l-2.5 2.5A10 10 0 0 0 2 11zM19 13a7 7 0 0 1-12 4l2-2H3v6l2.5-2.5A10 10 0 0 0 22 13z',
};

export type IconName = keyof typeof shapes;

export const Icon = ({ name }: { name: IconName }) => (
  <svg viewBox="0 0 24 24" width={18} height={18} aria-hidden="true" focusable="false">
    <path d={shapes[name]} fill="currentColor" />
  </svg>
);
