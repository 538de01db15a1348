// The view Write: a mouse is written, run in a maze, and raced against the built-in mice.
import { readAddress, type Moment } from '../link/address';
import { mazeAt } from '../link/mazes';
import { routeOf } from '../link/routes';
import type { Page, View } from '../page/page';
import { createRoot } from '../ui/root';
import { ControlsRoom, createControls } from '../write/controls';
import { createDesk, DeskRoom, type Desk } from '../write/desk';
import { createDisplay, DisplayRoom } from '../write/display';
import { createJobs } from '../write/jobs';
import { Prints } from '../write/prints';
import '../styles/forms.css';
import '../styles/write.css';

/** The parts of the view, and what they do to each other; `changed` hears of another program. */
function createParts(page: Page, changed: (allowed: boolean) => void) {
  const { element, draw } = createRoot('write', 'Write', () => (
    <>
      <h2 class="unseen">Write a mouse</h2>
      <DeskRoom desk={desk} press={press}>
        <ControlsRoom controls={controls}>
          <Prints {...display.state} go={display.player.seek} />
        </ControlsRoom>
      </DeskRoom>
      <DisplayRoom display={display} />
    </>
  ));
  const acts = {
    run: () => void jobs.run(),
    race: () => void jobs.race(),
    stop: () => jobs.stop(),
    work: () => desk.work(),
  };
  const controls = createControls(page, acts, draw);
  const desk: Desk = createDesk(page, changed, () => display.moment(), draw);
  const display = createDisplay(page, desk, controls, draw, () => element);
  const jobs = createJobs(page, desk, controls, display);
  /** The browser would write a line, or save the page. */
  function press(event: KeyboardEvent) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return;
    if (event.key === 'Enter') controls.run();
    else if (event.key === 's') desk.save();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
  draw();
  return { element, desk, controls, display, jobs };
}

type Parts = ReturnType<typeof createParts>;

/** What ran when the page was closed, or else a program to begin with, shows at once what it does; all else waits. */
function createBeginning(page: Page, { desk, controls, display, jobs }: Parts, isExpected: () => boolean) {
  let kept: Promise<unknown> | null = page.shelf.read('write');
  /** What ran here when the page was closed, once; null where nothing did. */
  async function ranBefore(): Promise<{ text: string; at: Moment } | null> {
    const { text, at } = ((await kept) ?? {}) as { text?: unknown; at?: unknown };
    kept = null;
    if (typeof text !== 'string' || typeof at !== 'string') return null;
    const { moment } = readAddress(at);
    controls.mazes.choose(moment, await mazeAt(page.core, moment));
    return { text, at: moment };
  }
  const isIdle = () => !isExpected() && !controls.state.isBusy && display.player.isEmpty() && desk.work() !== null;
  return async () => {
    if (!isIdle()) return;
    // What lies there may be of any page.
    const ran = await ranBefore().catch(() => null);
    const work = desk.work();
    if (!work || !isIdle()) return;
    if (ran?.text === work.text) void jobs.run(ran.at);
    else if (work.language.templates.some(({ text }) => text === work.text)) void jobs.run();
  };
}

export function createWrite(page: Page): View {
  const parts = createParts(page, changed);
  const { element, desk, controls, display, jobs } = parts;
  /** What the link says that the program came with, until it runs. */
  let linked: Moment | null = null;
  /** Links that are still being read. */
  let arriving = 0;
  const begin = createBeginning(page, parts, () => arriving > 0);

  function changed(allowed: boolean) {
    jobs.stop();
    if (!allowed) display.clear();
    controls.refresh();
    if (allowed && linked) void jobs.run(linked);
    linked = null;
    if (allowed || !desk.work()) return;
    // The program of a link is gone, so the address leads to it no longer.
    const route = routeOf(location.hash);
    if (route && 'program' in route) history.replaceState(null, '', '#write');
    void begin();
  }
  /** A program, and behind it where it was seen. */
  async function receive(link: string) {
    const [program, ...rest] = link.split('&');
    const { moment } = readAddress(['write', ...rest].join('&'));
    const maze = await mazeAt(page.core, moment);
    await desk.receive(program);
    linked = moment;
    controls.mazes.choose(moment, maze);
    controls.draw();
  }
  async function arrive(link: string) {
    arriving += 1;
    await receive(link).catch(page.complain);
    arriving -= 1;
    void begin();
  }
  return {
    element,
    shown() {
      controls.refresh();
      void begin();
    },
    hidden: () => display.player.stop(),
    address: desk.address,
    accept(thing) {
      const { link, file } = thing as { link?: string; file?: File };
      if (link !== undefined) void arrive(link);
      if (file) void desk.open(file);
    },
  };
}
