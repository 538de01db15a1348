// The page: its views around one core. It paints before the core has started, and a report's table needs no core.
import CoreWorker from './core/worker?worker&inline';
import { startCore, type Core } from './core/client';
import type { About, MazeData, PackedRecord, RaceResults } from './core/types';
import { blockText, readRecords, readReport } from './results/blocks';
import type { Order } from './results/holding';
import { myRobot, setMyRobot } from './link/my-robot';
import { loadedRace, type Sources } from './results/loaded';
import { fileTaker } from './shell/files';
import { createFrame } from './shell/frame';
import { lacking } from './shell/needs';
import { createNotices } from './shell/notices';
import { routeOf, titleOf } from './link/routes';
import { copyLink } from './shell/copy-link';
import { createFinder, createKeeper } from './shell/kept';
import { createShelf } from './page/shelf';
import { createStage, Link } from './shell/stage';
import { createDraw } from './views/draw';
import { createHome } from './views/home';
import { createLive } from './views/live';
import { createRace } from './views/race';
import { createReplay } from './views/replay';
import { createWrite } from './views/write';
import { createRobot } from './views/robot';
import type { EarlyPage, Page } from './page/page';
import type { LoadedRace } from './results/loaded';
import './styles/page.css';
import './styles/shell.css';

const noCore = (reason: string): Core => ({
  call: () => Promise.reject(new Error(reason)),
  stop: () => undefined,
});

const notices = createNotices();
const shelf = createShelf();
const frame = createFrame(notices, shelf, {
  take: (files) => void takeFiles(files),
  copyLink: () => void copyLink(stage, notices),
  stop: () => core.stop(),
});
const stage = createStage(frame, notices.complain);
const missing = lacking();
const core = missing ? noCore(missing) : startCore(() => new CoreWorker(), notices.busy);
const ready: Promise<About> = core.call('about', {});
// For those who open the browser's console: `await labmouse.call('about', {})`.
Object.assign(window, { labmouse: core });
const keeper = createKeeper(core, shelf);

/** Mazes that were opened in this page, by name, so that results find theirs. */
const opened = new Map<string, MazeData>();
let race: LoadedRace | null = null;
/** The one that the page was opened with. */
let report: LoadedRace | null = null;
let lastLink: string | null = null;

function setRace(results: RaceResults, more: Partial<Sources>) {
  race = loadedRace(results, { core, ready, links: new Map(), opened, records: async () => [], ...more });
}

function showResults(results: RaceResults, raced: MazeData[] = [], order?: Order, records: PackedRecord[] = []) {
  setRace(results, { raced, order, records: async () => records });
  keeper.results(results, raced);
  stage.show('race', results);
}

const page: EarlyPage = {
  core,
  ready,
  race: () => race,
  backToReport() {
    if (race === report || !report) return null;
    return () => stage.show('race', (race = report));
  },
  replay(plays, time, look) {
    keeper.plays(plays);
    stage.show('replay', { plays, time, look });
  },
  shelf,
  keepPlays: keeper.plays,
  keepMoment: keeper.moment,
  live: (maze) => stage.show('live', maze),
  draw: (maze) => stage.show('draw', maze),
  mazes: () => [...opened.values(), ...[stage.view('draw')?.maze?.() ?? []].flat()],
  drawn: () => stage.view('draw')?.maze?.() ?? null,
  open: (files) => void takeFiles(files),
  choose: frame.choose,
  hold(results, raced, message, order, records = []) {
    if (stage.current() === 'race') {
      showResults(results, raced, order, records);
      return notices.tell(message);
    }
    setRace(results, { raced, order, records: async () => records });
    keeper.results(results, raced);
    stage.keep('race', results);
    notices.tell(message, { label: 'Show it', act: () => stage.show('race', results) });
  },
  tell: notices.tell,
  complain: notices.complain,
  save(fileName, content, type = 'text/plain') {
    const url = URL.createObjectURL(new Blob([content], { type }));
    Object.assign(document.createElement('a'), { href: url, download: fileName }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  },
};

const takeFiles = fileTaker(core, notices, {
  mazes(mazes) {
    for (const maze of mazes) opened.set(maze.name, maze);
    keeper.mazes([...opened.values()]);
    page.live(mazes[mazes.length - 1]);
  },
  plays: (plays) => page.replay(plays),
  results: (results) => showResults(results),
  robot: (robot) => stage.show('robot', robot),
  program: (file) => stage.show('write', { file }),
  atHand: () =>
    (['draw', 'live'] as const).flatMap((name) => {
      const maze = stage.view(name)?.maze?.();
      return maze ? [{ place: titleOf(name), maze }] : [];
    }),
});

/** Goes where the address says; a maze in it opens in Draw, once. */
function follow() {
  const route = routeOf(location.hash);
  if (route && 'view' in route) {
    if (route.more) stage.show(route.view, new Link(location.hash), true);
    else if (route.view !== stage.current()) stage.show(route.view);
  } else if (!route) {
    if (stage.current() === null || location.hash === '')
      stage.show(blockText('labmouse-report') === null ? 'home' : 'race');
    if (location.hash.length > 1) notices.complain('This link leads nowhere: it names no view of this page.');
  } else if ('program' in route) stage.show('write', { link: route.program }, true);
  else if (route.link === lastLink) stage.show('draw');
  else void openLink((lastLink = route.link));
}

async function openLink(link: string) {
  notices.clear();
  stage.show('draw');
  if (link === '')
    return notices.complain('This link is incomplete: nothing follows maze=. Copy the whole link again.');
  try {
    const { maze } = await core.call('read_link', { link });
    // The link stays in the address, so that the page can be loaded again.
    stage.show('draw', maze, true);
  } catch (error) {
    notices.complain(error);
  }
}

async function recordsInside(): Promise<PackedRecord[]> {
  const block = blockText('labmouse-records');
  return block === null ? [] : (await readRecords(block)).records;
}

async function loadReport() {
  const text = blockText('labmouse-report');
  if (text === null) return;
  const { results, mazes } = await readReport(text);
  setRace(results, { links: new Map(Object.entries(mazes)), records: recordsInside });
  report = race;
}

/** Who opens a report of a single contest wants to see it. */
async function playTheOnlyContest() {
  if (!report) return;
  const records = await recordsInside();
  const maze = records.length === 1 && (await report.maze(records[0].maze));
  if (maze) page.replay([await core.call('unpack', { record: records[0], maze })]);
}

/** What was open when the page was closed; what came in the meantime, by a link or a file, is newer. */
async function restore() {
  const finder = createFinder(core, shelf);
  for (const maze of await finder.mazes()) if (!opened.has(maze.name)) opened.set(maze.name, maze);
  const found = await finder.results();
  if (found && !race) {
    setRace(found.results, { raced: found.raced });
    stage.offer('race', found.results);
  }
  const [robot, at] = [await finder.robot(), await finder.robotAt()];
  if (robot && myRobot() === null) {
    setMyRobot(`${robot.name}\n${robot.text}`);
    stage.offer('robot', { ...robot, at });
  } else if (at) stage.offer('robot', new Link(at));
  const live = await finder.live();
  if (live) stage.offer('live', new Link(live));
  const { plays, moment } = await finder.plays();
  if (plays.length > 0) stage.offer('replay', { plays, time: moment?.time, look: moment?.look });
}

async function startViews() {
  const about = await ready;
  const whole: Page = { ...page, about };
  stage.add('replay', createReplay(whole));
  stage.add('live', createLive(whole));
  stage.add('draw', createDraw(whole));
  stage.add('write', createWrite(whole));
  stage.add('robot', createRobot(whole));
}

async function start() {
  addEventListener('hashchange', follow);
  // Whoever tries again has read what went wrong.
  addEventListener('submit', notices.clear, true);
  const asked = location.hash.length > 1;
  follow();
  if (missing) notices.complain(missing);
  await loadReport().catch(notices.complain);
  stage.add('home', createHome(page));
  stage.add('race', createRace(page));
  await startViews().catch((error) => missing || notices.complain(error));
  await restore();
  if (!asked) await playTheOnlyContest().catch(notices.complain);
}

void start();
