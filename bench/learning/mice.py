"""Compares the learned mouse with built-in ones: the table of docs/research/solver-trials.md.

    build/bench-learning/bin/python bench/learning/mice.py

Uses the first 400 mazes of 'test', which were used neither for training nor for the choice of a policy. A failed
contest counts as 100 steps.
"""

import labmouse
from labmouse import learn


def main() -> None:
    learned = learn.Learned.load()
    mice = {"learned": learned, "learned, weights shuffled": learned.shuffled()}
    mice.update((name, name) for name in ("ariadne", "flood-return", "cautious", "random"))
    race = labmouse.race(mice, learn.MazeSet("test", count=400)[:], runs=5)
    print(f"{'the bound':26}{race.mazes['bound'].mean():8.2f}")
    for mouse in race.standings.to_dict("records"):
        low, high = mouse["interval"]
        steps = mouse["mean_search_steps"]
        print(f"{mouse['name']:26}{mouse['mean_par1']:8.2f}  {low:6.1f}-{high:.1f}  {mouse['finished']} of {mouse['runs']}"
              f", explores {steps:.0f} steps, {100 * mouse['optimal_share']:.0f} % shortest speed runs")
    for against in ("ariadne", "flood-return", "cautious", "learned, weights shuffled"):
        found = race.compare("learned", against)
        print(f"learned against {against}: {found.mean:+.2f} [{found.low:+.2f}, {found.high:+.2f}], {found.verdict}")


if __name__ == "__main__":
    main()
