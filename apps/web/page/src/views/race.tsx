// The view of a race: who is best, where, by how much, and each contest a click away from its replay.
import type { ComponentChildren } from 'preact';
import { useErrorBoundary, useMemo } from 'preact/hooks';
import { addressOf, readAddress } from '../link/address';
import type { EarlyPage, View } from '../page/page';
import { ComparePart, createComparePanel, type ComparePanel } from '../race/compare-part';
import { createHold, HoldPart, type Hold } from '../race/hold-part';
import { isQuick, orderIn, orderMoment } from '../race/linked-order';
import { Pictures, Tables, useRace } from '../race/race-parts';
import { createRaceStage, hasStage, StageBench, StageWords, type RaceStage } from '../race/stage';
import { exampleRace } from '../results/example';
import type { Board } from '../results/contests';
import type { LoadedRace } from '../results/loaded';
import { createRoot } from '../ui/root';
import '../styles/forms.css';
import '../styles/race.css';
import { errorText } from '../ui/format';

interface Props {
  page: EarlyPage;
  stage: RaceStage;
  /** The form, which stands first where nobody has held a race yet. */
  form: ComponentChildren;
  isFirst: boolean;
}

const Beside = ({ stage, children }: { stage: RaceStage; children: ComponentChildren }) => (
  <div class="race-stage">
    <div class="race">{children}</div>
    <StageBench stage={stage} />
  </div>
);

interface RaceProps extends Props {
  race: LoadedRace;
  /** Hears of the first board once its pictures are there. */
  drawn(first: Board): void;
  failed(error: unknown): void;
}

function Race({ page, stage, form, isFirst, race, drawn, failed }: RaceProps) {
  // Not while this is still being drawn.
  const [error] = useErrorBoundary((error) => void setTimeout(() => failed(error)));
  const raced = useRace(race, drawn);
  const { boards, search, orders } = raced;
  // They may be large, and a change of the form is none of theirs.
  const [tables, pictures] = useMemo(
    () => [<Tables page={page} raced={raced} isExample={isFirst} />, <Pictures page={page} raced={raced} />],
    [isFirst, boards, search, orders],
  );
  if (error) return null;
  if (!hasStage(race))
    return (
      <div class="race">
        {tables}
        {pictures}
        {form}
      </div>
    );
  return (
    <>
      <Beside stage={stage}>
        {isFirst && form}
        <StageWords stage={stage} />
        {tables}
      </Beside>
      <div class="race">
        {pictures}
        {!isFirst && form}
      </div>
    </>
  );
}

async function addressOfRace(page: EarlyPage, hold: Hold): Promise<string> {
  const about = await page.ready;
  const form = await hold.panel;
  const race = page.race();
  if (race && !race.order)
    throw new Error('These results came from a file: send the file. A link holds races of mice that the page has.');
  return addressOf('race', await orderMoment(page.core, about, race?.order ?? form.order()));
}

/** `view` is where the form stands. */
async function followRace(page: EarlyPage, hold: Hold, view: HTMLElement, hash: string) {
  const about = await page.ready;
  const form = await hold.panel;
  const order = await orderIn(page.core, about, readAddress(hash).moment);
  form.set(order);
  const element = view.querySelector('form.hold')!;
  const folded = element.closest('details');
  if (folded) folded.open = true;
  if (isQuick(about, order)) return form.start();
  element.scrollIntoView({ block: 'nearest' });
  page.tell('The race of this link is set up: start it when you like.');
}

/** What stands here: a race, or the form while there is none. */
function createRoom(page: EarlyPage) {
  const { element, draw } = createRoot('race-view', 'Race', () => {
    const { race, isFirst, hold } = state;
    if (!hold) return null;
    const form = [<HoldPart key={hold} hold={hold} first={isFirst} />, <ComparePart key="compare" panel={compare} />];
    const props = { page, stage, isFirst, form };
    return (
      <>
        <h2 class="unseen">Race</h2>
        {race ? (
          <Race key={race} {...props} {...{ race, drawn, failed }} />
        ) : (
          <Beside stage={stage}>{props.form}</Beside>
        )}
      </>
    );
  });
  const stage = createRaceStage(page, draw);
  let compare: ComparePanel | null = null;
  // What keeps the core from starting is said by the page itself.
  void page.ready.then(
    (about) => void (compare = createComparePanel(page, about, draw)),
    () => undefined,
  );
  /** The form as it is before there is a race, with what is chosen in it. */
  let firstForm: Hold | null = null;
  /** Nothing is drawn before the view is shown. */
  const state = { race: null as LoadedRace | null, isFirst: true, hold: null as Hold | null };
  /** `isFirst`: nobody has held a race yet. */
  function show(race: LoadedRace | null, isFirst: boolean) {
    const hold = isFirst ? (firstForm ??= createHold(page, draw)) : createHold(page, draw);
    if (!isFirst) firstForm = null;
    Object.assign(state, { race, isFirst, hold });
    stage.clear();
    draw();
  }
  function drawn(first: Board) {
    const { race } = state;
    if (race && hasStage(race)) stage.perform(race, first, () => race === state.race);
  }
  function failed(error: unknown) {
    show(null, true);
    page.complain(`These results cannot be shown: ${errorText(error)}`);
  }
  return { element, stage, show, hold: () => state.hold! };
}

export function createRace(page: EarlyPage): View {
  const { element, stage, show, hold } = createRoom(page);
  /** What stands here until there is a race: null before it was held. */
  let example: LoadedRace | null = null;
  /** Whether it is being held. */
  let holding = false;
  let shown: LoadedRace | null | undefined;

  /** Whether the example is still what should stand here. */
  const lacksRace = () => page.race() === null && !element.hidden;
  async function holdExample() {
    if (holding || example) return;
    holding = true;
    // What keeps the core from starting is said by the page itself.
    const held = await exampleRace(page, lacksRace).catch(() => null);
    holding = false;
    if (held && lacksRace()) show((shown = example = held), true);
  }
  return {
    element,
    shown() {
      const race = page.race() ?? example;
      // What a link asks for is on its way.
      if (!race && !location.hash.startsWith('#race&')) void holdExample();
      if (race !== shown) show((shown = race), race === null || race === example);
      void hold().panel.then(
        (panel) => panel.refresh(),
        () => undefined,
      );
    },
    hidden: stage.player.stop,
    address: () => addressOfRace(page, hold()),
    follow: (hash) => followRace(page, hold(), element, hash),
  };
}
