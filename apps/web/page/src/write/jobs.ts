// Runs a program in a maze, or races it; one at a time, and stopped by the next.
import { Stopped } from '../core/client';
import type { Moment } from '../link/address';
import type { Page } from '../page/page';
import { mazesOf } from '../results/holding';
import { holdContest } from './contest';
import type { Controls } from './controls';
import type { Desk } from './desk';
import type { Display } from './display';
import type { Work } from './keeping';
import { raceProgram, type Version } from './racing';
import { createCage, type Cage } from './sandbox/cage';
import { errorText } from '../ui/format';

/** As `labmouse run` and `labmouse race` have it. */
const seed = 1;
const usualRuns = 20;

const runnerOf = ({ language, text: program, name }: Work) => ({ language, program, name });

/** One job at a time. */
function createTurns(page: Page, desk: Desk, controls: Controls, cage: Cage) {
  /** Counts up with each job; one whose number is past is no longer wanted. */
  let number = 0;
  function stop() {
    number += 1;
    cage.close();
    page.core.stop('race');
    controls.busy(false);
    // What was under way comes to no end.
    if (controls.state.verdict?.kind === 'fair') controls.set({ verdict: null });
  }
  /** Does that with the program, and says what went wrong with it. */
  async function doing(act: (work: Work, wanted: () => boolean) => Promise<void>) {
    const work = desk.work();
    if (!work) return;
    if (work.name === '') return desk.complain('Give your mouse a name, by which the leaderboard can call it.');
    stop();
    const mine = ++number;
    controls.busy(true);
    desk.complain('');
    desk.fail(null);
    try {
      await act(work, () => mine === number);
    } catch (error) {
      if (mine !== number || error instanceof Stopped) return;
      const message = errorText(error);
      controls.set({ verdict: null });
      if (/\bname\b/.test(message)) desk.complain(message);
      else page.complain(error);
    } finally {
      if (mine === number) controls.busy(false);
    }
  }
  return { stop, doing };
}

export function createJobs(page: Page, desk: Desk, controls: Controls, display: Display) {
  const cage = createCage();
  const { stop, doing } = createTurns(page, desk, controls, cage);
  /** The program as it raced last, and as it was before it was changed. */
  let raced: Version | null = null;
  let before: Version | null = null;

  async function run(work: Work, wanted: () => boolean, at?: Moment) {
    controls.say(`${work.name || 'It'} runs …`, 'fair');
    const [maze] = await mazesOf(page.core, [controls.mazes.chosen()]);
    const held = await holdContest(page.core, cage, { ...runnerOf(work), maze, seed }, wanted);
    if (held?.started) display.show(held, work.text, at);
    else if (held) display.showNoStart(held);
  }
  async function race(work: Work, wanted: () => boolean) {
    const { form, report } = controls;
    const chosen = form.mazes.chosenMazes();
    if (chosen.length === 0) return page.complain('Choose at least one maze.');
    const order = { mice: form.mice.chosen(), mazes: await mazesOf(page.core, chosen), runs: usualRuns, seed };
    const changed = raced && (raced.runner.program !== work.text || raced.runner.language !== work.language);
    const last = changed ? raced : before;
    const reported: typeof report = (progress) => wanted() && report(progress);
    const race = await raceProgram(page.core, cage, runnerOf(work), order, reported, wanted, last);
    if (!race || !wanted()) return;
    if ('failed' in race) return display.showNoStart(race.failed);
    before = last;
    raced = race.now;
    display.showRace(race, work.text);
  }
  return {
    stop,
    run: (at?: Moment) => doing((work, wanted) => run(work, wanted, at)),
    race: () => doing(race),
  };
}
