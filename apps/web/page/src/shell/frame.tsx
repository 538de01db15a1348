// What stands around the views.
import { render, type SVGAttributes } from 'preact';
import type { Shelf } from '../page/shelf';
import { titleOf, viewNames, type ViewName } from '../link/routes';
import { askForFiles } from '../ui/pick';
import { Drop } from './drop';
import { Menu } from './menu';
import { Alerts, Status, Work, type Notices } from './notices';
import { startTheme, ThemeSwitch } from './theme';
import { Button } from '../ui/controls';

export type Frame = ReturnType<typeof createFrame>;

const Sign = ({ size, ...path }: { size: number } & SVGAttributes<SVGPathElement>) => (
  <svg viewBox="0 0 24 24" width={size} height={size} aria-hidden="true" focusable="false">
    <path {...path} />
  </svg>
);
/** The mouse of the pictures. */
const mouse = { d: 'M12 2l8 19-8-5-8 5z', fill: 'currentColor' };
const folder = { d: 'M3 5h6l2 2h10v12H3zM5 9v8h14V9z', fill: 'currentColor' };
const chain = {
  ...{ d: 'M10 14l4-4M9 7l2-2a4.2 4.2 0 0 1 6 6l-2 2M15 17l-2 2a4.2 4.2 0 0 1-6-6l2-2', fill: 'none' },
  ...{ stroke: 'currentColor', 'stroke-width': 2, 'stroke-linecap': 'round' as const },
};

interface Acts {
  take(files: File[]): void;
  copyLink(): void;
  /** Ends what takes long. */
  stop(): void;
}

interface Props {
  notices: Notices;
  shelf: Shelf;
  acts: Acts;
  /** The view that is shown; null before the first. */
  view: ViewName | null;
  isStarting: boolean;
}

const main = () => document.getElementById('main')!;
const chooseFiles = (take: Acts['take']) => askForFiles(take, { multiple: true });

const Header = ({ notices, shelf, acts, view }: Props) => (
  <header class="top">
    <Button label="Skip to the content" class="skip" act={() => main().focus()} />
    <h1>
      <a class="brand" href="#home" title="To the home page">
        <Sign size={22} {...mouse} />
        <span>labmouse</span>
      </a>
    </h1>
    <nav aria-label="Views">
      {viewNames.map((name) => (
        <a href={`#${name}`} aria-current={name === view ? 'page' : undefined}>
          {titleOf(name)}
        </a>
      ))}
    </nav>
    <Status notices={notices} />
    <Work notices={notices} stop={acts.stop} />
    <Menu shelf={shelf} notices={notices}>
      <button
        type="button"
        class="open"
        title="A maze, a record or the results of a race"
        onClick={() => chooseFiles(acts.take)}
      >
        <Sign size={18} {...folder} />
        <span>Open file</span>
      </button>
      <button type="button" class="open" title="A link to what is seen now" onClick={acts.copyLink}>
        <Sign size={18} {...chain} />
        <span>Copy link</span>
      </button>
      <ThemeSwitch />
    </Menu>
  </header>
);

export function createFrame(notices: Notices, shelf: Shelf, acts: Acts) {
  const state = { view: null as ViewName | null, isStarting: false };
  const draw = () =>
    render(
      <>
        <Header {...{ notices, shelf, acts, ...state }} />
        <Alerts notices={notices} />
        <main id="main" tabIndex={-1}>
          <p class="starting" hidden={!state.isStarting}>
            Starting …
          </p>
        </main>
        <Drop take={acts.take} />
      </>,
      document.getElementById('page')!,
    );
  document.getElementById('page')!.replaceChildren();
  startTheme();
  draw();
  notices.watch(draw);
  return {
    /** Where the views stand. */
    main: main(),
    /** Lets the user choose files. */
    choose: () => chooseFiles(acts.take),
    setStarting(is: boolean) {
      state.isStarting = is;
      draw();
    },
    /** Marks the view that is shown, in the navigation and in the title. */
    mark(view: ViewName) {
      state.view = view;
      draw();
      const tab = document.querySelector('nav [aria-current]');
      tab?.scrollIntoView({ block: 'nearest', inline: 'nearest', behavior: 'instant' });
      document.title = view === 'home' ? 'labmouse' : `${titleOf(view)} · labmouse`;
    },
  };
}
