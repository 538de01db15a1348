// The race of a program: its place among the mice, and the steps that it lost in each maze.
import { Leaderboard } from '../race/leaderboard';
import { groupsOf } from '../results/contests';
import type { ContestOutput } from './contest';
import { Losses } from './losses';
import type { Raced } from './racing';

const contestsOf = ({ now }: Raced) => now.contests;
const nameOf = ({ now, before }: Raced) => ({
  name: now.contests[0].play.mouse,
  old: before?.contests[0].play.mouse,
});

/** "my-mouse is number 2 of 6: finished 9 of 10 mazes", and whether that was all of them. */
export function placeInWords(raced: Raced): [words: string, finishedAll: boolean] {
  const [group] = groupsOf(raced.results);
  const { name, old } = nameOf(raced);
  const place = (of: string) => group.mice.findIndex((mouse) => mouse.name === of) + 1;
  const contests = contestsOf(raced);
  const finished = contests.filter(({ play }) => play.finished).length;
  const than = old === undefined ? '' : `; ${old} is number ${place(old)}`;
  return [
    `${name} is number ${place(name)} of ${group.mice.length}: finished ${finished} of ${contests.length} mazes${than}`,
    finished === contests.length,
  ];
}

/** `open` shows a contest of the program. */
export function Standings({ raced, open }: { raced: Raced; open(held: ContestOutput): void }) {
  const [group] = groupsOf(raced.results);
  const { name, old } = nameOf(raced);
  return (
    <section class="race pictures standings" aria-label="Its race">
      <h2>Leaderboard</h2>
      <Leaderboard key={group} group={group} own={old === undefined ? [name] : [name, old]} />
      <h2>Steps that {name} lost in each maze</h2>
      <Losses contests={contestsOf(raced)} open={open} />
      <p class="note">
        All results of this race, with pictures, are in <a href="#race">Race</a>.
      </p>
    </section>
  );
}
