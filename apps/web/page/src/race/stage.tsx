// The best mouse of a race on a stage beside its tables.
import type { EarlyPage } from '../page/page';
import { createPlayer, PlayerRoom } from '../player/player';
import { groupsOf, type Board } from '../results/contests';
import type { LoadedRace } from '../results/loaded';
import { worldOf } from '../results/worlds';
import { scoreText } from '../ui/format';
import { contestPlay } from './contest-play';

/**
 * Whether one of its contests can be put on a stage: what came in a file may be large, and be of mice that the page cannot
 * run, and there are worlds in which it runs none again.
 */
export function hasStage({ order, results }: LoadedRace): boolean {
  const [group] = groupsOf(results);
  return order !== undefined && group !== undefined && worldOf(group).again !== undefined;
}

export type RaceStage = ReturnType<typeof createRaceStage>;

/** `draw` is called where it says something else. */
export function createRaceStage(page: EarlyPage, draw: () => void) {
  const player = createPlayer(page);
  let words = '';
  return {
    player,
    words: () => words,
    clear() {
      words = '';
      player.show([]);
    },
    /** The best mouse in the first maze, while that is `wanted`. */
    perform(race: LoadedRace, board: Board, wanted: () => boolean) {
      contestPlay(page, race, board, { mouse: 0, maze: 0, position: 0 })
        .then((one) => {
          if (!wanted()) return;
          player.show([one], 'end');
          const { mouse, maze, score } = one.play;
          words = `On the stage: ${mouse} in ${maze.name}, score ${scoreText(score)}.`;
          draw();
        })
        .catch(page.complain);
    },
  };
}

export const StageBench = ({ stage }: { stage: RaceStage }) => (
  <div class="bench">
    <PlayerRoom player={stage.player} />
  </div>
);

export const StageWords = ({ stage }: { stage: RaceStage }) => (
  <p class="unseen on-stage" role="status">
    {stage.words()}
  </p>
);
