// The view of a race: who is best, where, by how much, and each contest a click away from its replay.
import { addressOf, readAddress } from '../link/address';
import type { EarlyPage, View } from '../page/page';
import { holdPart, type HoldPart } from '../race/hold-part';
import { isQuick, orderIn, orderMoment } from '../race/linked-order';
import { raceParts, type Painted } from '../race/race-parts';
import { createRaceStage, hasStage } from '../race/stage';
import { exampleRace } from '../results/example';
import type { LoadedRace } from '../results/loaded';
import { h } from '../ui/dom';
import { onTones } from '../ui/tones';
import '../styles/forms.css';
import '../styles/race.css';
import { errorText } from '../ui/format';

/** Where a race is shown, or the form while there is none. */
function createRaceRoom(page: EarlyPage) {
  const element = h('section.race-view', { 'aria-label': 'Race' });
  const stage = createRaceStage(page);
  let painted: Painted[] = [];
  let shown: LoadedRace | null | undefined;
  let hold: HoldPart | null = null;
  /** The form as it is before there is a race, with what is chosen in it. */
  let firstForm: HoldPart | null = null;

  const arrange = () => !element.hidden && painted.forEach((one) => one.arrange());
  /** `isFirst`: nobody has held a race yet. */
  function render(race: LoadedRace | null, isFirst: boolean) {
    shown = race;
    painted = [];
    stage.clear();
    hold = isFirst ? (firstForm ??= holdPart(page, true)) : holdPart(page, false);
    if (!isFirst) firstForm = null;
    const column = (...content: HTMLElement[]) => h('div.race', ...content);
    const beside = (...content: HTMLElement[]) => h('div.race-stage', column(...content), stage.element);
    const title = h('h2.unseen', 'Race');
    if (!race) return element.replaceChildren(title, beside(hold.element));
    const wanted = () => race === shown;
    const { tables, pictures } = raceParts(page, race, isFirst, wanted, (made, board) => {
      painted = made;
      arrange();
      if (hasStage(race)) stage.perform(race, board, wanted);
    });
    if (!hasStage(race)) element.replaceChildren(title, column(...tables, pictures, hold.element));
    else if (isFirst) element.replaceChildren(title, beside(hold.element, stage.words, ...tables), column(pictures));
    else element.replaceChildren(title, beside(stage.words, ...tables), column(pictures, hold.element));
  }
  onTones(arrange);
  let width = 0;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    arrange();
  }).observe(element);
  return { element, render, arrange, stop: stage.stop, panel: () => hold?.panel };
}

type RaceRoom = ReturnType<typeof createRaceRoom>;

async function addressOfRace(page: EarlyPage, room: RaceRoom): Promise<string> {
  const about = await page.ready;
  const form = await room.panel()!;
  const race = page.race();
  if (race && !race.order)
    throw new Error('These results came from a file: send the file. A link holds races of mice that the page has.');
  return addressOf('race', await orderMoment(page.core, about, race?.order ?? form.order()));
}

async function followRace(page: EarlyPage, room: RaceRoom, hash: string) {
  const about = await page.ready;
  const form = await room.panel()!;
  const order = await orderIn(page.core, about, readAddress(hash).moment);
  form.set(order);
  const folded = form.element.closest('details');
  if (folded) folded.open = true;
  if (isQuick(about, order)) return form.start();
  form.element.scrollIntoView({ block: 'nearest' });
  page.tell('The race of this link is set up: start it when you like.');
}

export function createRace(page: EarlyPage): View {
  const room = createRaceRoom(page);
  /** What stands here until there is a race: null before it was held. */
  let example: LoadedRace | null = null;
  /** Whether it is being held. */
  let holding = false;
  let shown: LoadedRace | null | undefined;

  /** Whether the example is still what should stand here. */
  const lacksRace = () => page.race() === null && !room.element.hidden;
  const render = (race: LoadedRace | null) => room.render(race, race === null || race === example);
  async function holdExample() {
    if (holding || example) return;
    holding = true;
    // What keeps the core from starting is said by the page itself.
    const held = await exampleRace(page, lacksRace).catch(() => null);
    holding = false;
    if (!held || !lacksRace()) return;
    shown = example = held;
    render(held);
    room.arrange();
  }
  function show(race: LoadedRace | null) {
    shown = race;
    try {
      render(race);
    } catch (error) {
      render(null);
      page.complain(`These results cannot be shown: ${errorText(error)}`);
    }
  }
  return {
    element: room.element,
    shown() {
      const race = page.race() ?? example;
      // What a link asks for is on its way.
      if (!race && !location.hash.startsWith('#race&')) void holdExample();
      if (race !== shown) show(race);
      void room.panel()?.then(
        (panel) => panel.refresh(),
        () => undefined,
      );
      room.arrange();
    },
    hidden: room.stop,
    address: () => addressOfRace(page, room),
    follow: (hash) => followRace(page, room, hash),
  };
}
