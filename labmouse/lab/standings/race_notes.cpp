#include "labmouse/lab/standings/race_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "labmouse/lab/standings/misstep_lines.hpp"
#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Share of the runs that a mouse solved in each maze, to see whether two means cover the same mazes alike.
std::vector<double> solved_shares(const Race& race, std::size_t mouse) {
  std::vector<int> runs(race.mazes.size()), solved(race.mazes.size());
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest)) continue;
    ++runs[contest.maze];
    solved[contest.maze] += contest.score.value ? 1 : 0;
  }
  std::vector<double> shares;
  for (std::size_t maze = 0; maze < runs.size(); ++maze)
    shares.push_back(runs[maze] > 0 ? solved[maze] / static_cast<double>(runs[maze]) : 0.0);
  return shares;
}

bool solved_different_mazes(const Race& race) {
  for (std::size_t mouse = 1; mouse < race.mice.size(); ++mouse)
    if (solved_shares(race, mouse) != solved_shares(race, 0)) return true;
  return false;
}

/// How a mouse failed, and how often: "out of steps 3, forfeit (died) 1"; empty where it did not.
std::string failures_of(const Race& race, std::size_t mouse) {
  std::map<std::pair<Outcome, ForfeitReason>, int> times;
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && counts(race, contest) && !contest.score.value)
      ++times[{contest.score.outcome, contest.reason}];
  std::string text;
  for (const auto& [way, count] : times) {
    const std::string reason = way.first == Outcome::forfeit ? fmt::format(" ({})", name_of(way.second)) : "";
    text += fmt::format("{}{}{} {}", text.empty() ? "" : ", ", name_of(way.first), reason, count);
  }
  return text;
}

/// Whether a maze is as the capstone project's: square, with even sides, from the south-west corner to the centre.
bool as_robots_expect(const Maze& maze) {
  const Size size = maze.size();
  return size.width == size.height && size.width % 2 == 0 && maze.start() == Cell{} &&
         maze.start_heading() == Heading::north && maze.goals() == centre_of(size);
}

/// How the first failed contest of a mouse that had something to say ended, and its last words.
std::string last_words_of(const Race& race, std::size_t mouse) {
  const auto found = std::find_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
    return contest.mouse == mouse && contest.done && !contest.score.value && !contest.last_words.empty();
  });
  if (found == race.results.end()) return "";
  std::string_view words = found->last_words;
  std::string how(name_of(found->score.outcome));
  if (found->score.outcome == Outcome::forfeit) {
    const auto end = std::min(words.find('\n'), words.size());
    how = words.substr(0, end);
    words.remove_prefix(end);
  }
  std::string text = fmt::format("    first in {}: {}\n", shown(race.mazes[found->maze].name), shown(how));
  for (const std::string& line : last_lines(words)) text += fmt::format("    | {}\n", shown(line));
  return text;
}

/// Capstone robots are told the size of a maze and nothing else.
std::string note_on_robots(const Race& race) {
  const bool robots = std::any_of(race.mice.begin(), race.mice.end(),
                                  [](const Contestant& m) { return m.name.starts_with("capstone:"); });
  std::vector<std::string> others;
  for (const NamedMaze& maze : race.mazes)
    if (!as_robots_expect(maze.maze)) others.push_back(shown(maze.name));
  if (!robots || others.empty()) return "";
  const bool one = others.size() == 1;
  return fmt::format(
      "Capstone robots are told the size alone, and {} not as they expect (a square with even sides,\n"
      "from (0,0) north to the centre): {}{}.\n",
      one ? "1 maze is" : fmt::format("{} mazes are", others.size()), others.front(),
      one ? "" : fmt::format(", {}{}", others[1], others.size() > 2 ? ", ..." : ""));
}

/// A line for each mouse that failed, with the last words of those that are other programs.
std::string failures_of(const Race& race) {
  const MouseColumn names(race);
  std::string lines;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse)
    if (const auto failures = failures_of(race, mouse); !failures.empty())
      lines += fmt::format("  {:<{}} {}\n", names.of[mouse], names.width, failures) + last_words_of(race, mouse);
  return lines.empty() ? "" : "Failures:\n" + lines;
}

std::string first_routeless(const Race& race) {
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
    if (!race.bounds[maze].score) return shown(race.mazes[maze].name);
  return "";
}

}  // namespace

std::string notes_of(const Race& race) {
  const Rules& rules = race.order.rules;
  std::string notes = fmt::format(
      "Score: speed-run steps + exploration steps / {}; lower is better.\n"
      "A failed contest counts {:g} in 'all' and is left out of 'solved'.\n",
      rules.exploration_factor, rules.failure_score);
  if (solved_different_mazes(race))
    notes += "Mean scores over 'solved' cover different mazes for different mice: compare 'all'.\n";
  const auto dear = std::count_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
    return counts(race, contest) && contest.score.value.value_or(0.0) > rules.failure_score;
  });
  if (dear > 0)
    notes += fmt::format("{} solved with a score above {:g}, so that failing would have counted less.\n",
                         counted(static_cast<int>(dear), "contest was", "contests were"), rules.failure_score);
  notes += failures_of(race) + misstep_lines(race) + note_on_robots(race);
  const auto routeless = static_cast<int>(
      std::count_if(race.bounds.begin(), race.bounds.end(), [](const Bound& bound) { return !bound.score; }));
  if (routeless > 0)
    notes += fmt::format("Left out of all means: {} whose goal cannot be reached ({}{}).\n",
                         counted(routeless, "maze", "mazes"), first_routeless(race), routeless > 1 ? ", ..." : "");
  if (std::any_of(race.mice.begin(), race.mice.end(), [](const Contestant& m) { return m.reference; }))
    notes += "* knows the maze: the bound's witness, not a contestant.\n";
  if (race.stopped) {
    const auto done =
        std::count_if(race.results.begin(), race.results.end(), [](const ContestResult& r) { return r.done; });
    notes += fmt::format("Stopped early: {} of {} contests done.\n", done, race.results.size());
  }
  return notes;
}

}  // namespace labmouse
