#include "labmouse/lab/steps/steps_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/steps/action_error_lines.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Share of the runs that a mouse finished in each maze, to see whether two means cover the same mazes alike.
std::vector<double> finished_shares(const Race& race, std::size_t mouse) {
  std::vector<int> runs(race.mazes.size()), finished(race.mazes.size());
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest)) continue;
    ++runs[contest.maze];
    finished[contest.maze] += contest.score ? 1 : 0;
  }
  std::vector<double> shares;
  for (std::size_t maze = 0; maze < runs.size(); ++maze)
    shares.push_back(runs[maze] > 0 ? finished[maze] / static_cast<double>(runs[maze]) : 0.0);
  return shares;
}

bool finished_different_mazes(const Race& race) {
  for (std::size_t mouse = 1; mouse < race.mice.size(); ++mouse)
    if (finished_shares(race, mouse) != finished_shares(race, 0)) return true;
  return false;
}

/// Whether a maze is as the capstone project's: square, with even sides, from the south-west corner to the centre.
bool as_robots_expect(const Maze& maze) {
  const Size size = maze.size();
  return size.width == size.height && size.width % 2 == 0 && maze.start() == Cell{} &&
         maze.start_heading() == Heading::north && maze.goals() == centre_of(size);
}

/// Capstone robots know the size of a maze and nothing else.
std::string note_on_robots(const Race& race) {
  const bool robots = std::any_of(race.mice.begin(), race.mice.end(),
                                  [](const Contestant& m) { return spec_of(m).starts_with("capstone:"); });
  std::vector<std::string> others;
  for (const NamedMaze& maze : race.mazes)
    if (!as_robots_expect(maze.maze)) others.push_back(shown(maze.name));
  if (!robots || others.empty()) return "";
  const bool one = others.size() == 1;
  return fmt::format(
      "Capstone robots know only the size, and {} not as they expect (a square with even sides,\n"
      "from (0,0) north to the centre): {}{}.\n",
      one ? "1 maze is" : fmt::format("{} mazes are", others.size()), others.front(),
      one ? "" : fmt::format(", {}{}", others[1], others.size() > 2 ? ", ..." : ""));
}

}  // namespace

std::string steps_notes(const Race& race, const Rules& rules) {
  std::string notes = fmt::format(
      "Score: {}; lower is better.\n"
      "A failed contest counts {:g}.\n",
      race.world().traits().formula, rules.failure_score);
  if (finished_different_mazes(race))
    notes += "Different mice finished different mazes; 'mean score' counts all of them.\n";
  const auto dear = std::count_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
    return counts(race, contest) && contest.score.value_or(0.0) > rules.failure_score;
  });
  if (dear > 0)
    notes += fmt::format("{} a score above {:g}, more than a failed one.\n",
                         counted(dear, "finished contest has", "finished contests have"), rules.failure_score);
  return notes;
}

std::string steps_remarks(const Race& race) { return action_error_lines(race) + note_on_robots(race); }

}  // namespace labmouse
