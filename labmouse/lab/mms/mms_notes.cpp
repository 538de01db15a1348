#include "labmouse/lab/mms/mms_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mms/mms_figures.hpp"
#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using F = MmsFigures;

std::vector<std::string> lines_of(const JsonText& list) {
  return ReadJson::parse(list.text).get<std::vector<std::string>>();
}

/// Whether a run failed: in a maze in which nobody can score, none does.
bool ended_badly(const Race& race, const ContestResult& contest) {
  return counts(race, contest) && figures_of<F>(contest).outcome != name_of(MmsOutcome::complete);
}

bool never_ended_and_finished(const ContestResult& contest) {
  return contest.done && contest.score && figures_of<F>(contest).outcome == name_of(MmsOutcome::never_ended);
}

/// The first of a mouse's runs that is as asked; null where none is.
template <class Wanted>
const ContestResult* first_run(const Race& race, std::size_t mouse, Wanted wanted) {
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && contest.done && wanted(contest)) return &contest;
  return nullptr;
}

/// How often a mouse ended otherwise than by exit code 0: "failed 1, hung 3".
std::string ends_of(const Race& race, std::size_t mouse) {
  std::string text;
  for (std::size_t outcome = 1; outcome <= static_cast<std::size_t>(MmsOutcome::interrupted); ++outcome) {
    const std::string_view name = name_of(static_cast<MmsOutcome>(outcome));
    const auto times = std::count_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
      return contest.mouse == mouse && counts(race, contest) && figures_of<F>(contest).outcome == name;
    });
    if (times > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, times);
  }
  return text;
}

/// For each mouse with such runs: their number, how the first of them ended, and its last lines of standard error.
std::string ends_of(const Race& race, const MouseColumn& names) {
  std::string text;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    const auto* first =
        first_run(race, mouse, [&](const ContestResult& contest) { return ended_badly(race, contest); });
    if (first == nullptr) continue;
    text += fmt::format("  {}: {}; first in {}: {}\n", names.of[mouse], ends_of(race, mouse),
                        shown(race.mazes[first->maze].name), shown(figures_of<F>(*first).end));
    for (const std::string& line : lines_of(figures_of<F>(*first).errors)) text += "    | " + shown(line) + "\n";
  }
  if (text.empty()) return "";
  const bool any_never_ended = std::any_of(race.results.begin(), race.results.end(), never_ended_and_finished);
  return (any_never_ended ? "A run that never ended has the score that it had when its best run was finished.\n" : "") +
         ("Runs that did not end with exit code 0:\n" + text);
}

std::int64_t sum_of_lines(const Race& race, std::size_t mouse, std::int64_t F::*figure) {
  std::int64_t all = 0;
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && contest.done) all += figures_of<F>(contest).*figure;
  return all;
}

std::string invalid_lines_of(const Race& race, const MouseColumn& names) {
  std::string text;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    const auto* first =
        first_run(race, mouse, [](const ContestResult& contest) { return figures_of<F>(contest).invalid_lines > 0; });
    if (first == nullptr) continue;
    const std::vector<std::string> log = lines_of(figures_of<F>(*first).log);
    text += fmt::format("  {}: {} of {}; first in {}: {}\n", names.of[mouse],
                        sum_of_lines(race, mouse, &F::invalid_lines), sum_of_lines(race, mouse, &F::lines),
                        shown(race.mazes[first->maze].name), log.empty() ? "" : shown(log.front()));
  }
  return text.empty() ? "" : "Lines that are not commands, which mms does not answer:\n" + text;
}

/// Whether mms starts or ends elsewhere than the file says.
bool marked_otherwise(const NamedMaze& maze) {
  return maze.maze.start() != Cell(0, 0) || maze.maze.goals() != mms_goals(maze.maze.size());
}

}  // namespace

std::string mms_notes(const Race& race) {
  std::string notes =
      "Score, as in mms: effective distance + turns of the best run + a tenth of all\neffective distance and turns "
      "(total). Unfinished counts 2000. Lower is better.\n";
  const auto otherwise = static_cast<int>(std::count_if(race.mazes.begin(), race.mazes.end(), marked_otherwise));
  if (otherwise > 0)
    notes += fmt::format("mms starts at (0,0) and its goal is the centre, unlike what {} {}.\n",
                         counted(otherwise, "maze", "mazes"), otherwise == 1 ? "says" : "say");
  return notes;
}

std::string mms_remarks(const Race& race) {
  const MouseColumn names(race);
  return ends_of(race, names) + invalid_lines_of(race, names);
}

}  // namespace labmouse
