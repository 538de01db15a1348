#include "labmouse/lab/standings/race_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/last_lines.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// The outcome of a contest in words for a list: "forfeit: late" as "forfeit (late)".
std::string in_a_list(const std::string& outcome) {
  const auto colon = outcome.find(": ");
  return colon == std::string::npos ? outcome
                                    : fmt::format("{} ({})", outcome.substr(0, colon), outcome.substr(colon + 2));
}

/// How a mouse failed, and how often: "out of steps 3, forfeit (late) 1"; empty where it did not.
std::string failures_of(const Race& race, std::size_t mouse) {
  std::map<std::pair<int, std::string>, int> times;
  for (const ContestResult& contest : race.results)
    if (contest.mouse == mouse && counts(race, contest) && !contest.score)
      ++times[{contest.outcome_order, in_a_list(contest.outcome)}];
  std::string text;
  for (const auto& [way, count] : times) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", way.second, count);
  return text;
}

/// For the first failed contest of a mouse that has last words: its outcome, and these words. In a maze in which
/// nobody can score no contest is a failure.
std::string last_words_of(const Race& race, std::size_t mouse) {
  for (const ContestResult& contest : race.results) {
    if (contest.mouse != mouse || !counts(race, contest) || contest.score) continue;
    const Value said = figure_of(race, contest, said_last);
    if (!std::holds_alternative<std::string>(said)) continue;
    std::string_view words = std::get<std::string>(said);
    std::string how = contest.outcome;
    // A forfeit begins with its own sentence about what went wrong.
    if (how.find(": ") != std::string::npos) {
      const auto end = std::min(words.find('\n'), words.size());
      how = words.substr(0, end);
      words.remove_prefix(end);
    }
    std::string text = fmt::format("    first in {}: {}\n", shown(race.mazes[contest.maze].name), shown(how));
    for (const std::string& line : last_lines(words)) text += fmt::format("    | {}\n", shown(line));
    return text;
  }
  return "";
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

struct FinishedOf {
  int finished = 0, all = 0;
};

/// For mice whose failures follow the size of the mazes: "flood finished all 13 contests in 16x16, and 3 of 30 in other
/// sizes".
std::string sizes_of(const Race& race) {
  constexpr int fewest = 3;  // contests in sizes without failures
  std::string lines;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    std::map<std::pair<int, int>, FinishedOf> sizes;
    for (const ContestResult& contest : race.results) {
      if (contest.mouse != mouse || !counts(race, contest)) continue;
      const Size size = race.mazes[contest.maze].maze.size();
      FinishedOf& counted_here = sizes[{size.width, size.height}];
      ++counted_here.all;
      counted_here.finished += contest.score ? 1 : 0;
    }
    FinishedOf good, others;
    std::string names;
    for (const auto& [size, count] : sizes) {
      FinishedOf& sum = count.finished == count.all ? good : others;
      sum.finished += count.finished;
      sum.all += count.all;
      if (&sum == &good) names += fmt::format("{}{}x{}", names.empty() ? "" : ", ", size.first, size.second);
    }
    if (good.all >= fewest && 2 * others.finished < others.all)
      lines += fmt::format("{} finished all {} contests in {}, and {} of {} in other sizes.\n",
                           shown(race.mice[mouse].name), good.all, names, others.finished, others.all);
  }
  return lines;
}

/// The mazes in which nobody can score.
std::string left_out_of(const Race& race) {
  int closed = 0;
  std::string first;
  for (std::size_t maze = 0; maze < race.mazes.size(); ++maze)
    if (race.facts[maze].found && !race.facts[maze].bound && closed++ == 0) first = shown(race.mazes[maze].name);
  if (closed == 0) return "";
  return fmt::format("Left out of all means: {} {} ({}{}).\n", counted(closed, "maze", "mazes"),
                     race.world().traits().why_no_bound, first, closed > 1 ? ", ..." : "");
}

/// Whether its contests depend on their seeds. External mice get another one, the same in all mazes.
bool uses_seeds(const Race& race) {
  return race.world().traits().is_stochastic ||
         std::any_of(race.mice.begin(), race.mice.end(), [](const Contestant& mouse) { return mouse.uses_chance; });
}

/// The mazes that share their seeds with another one: the seed of a contest follows from the file name alone, so that
/// a maze has the same contests wherever it lies and whatever races beside it.
std::string shared_seeds_of(const Race& race) {
  std::map<std::string, std::vector<std::string>> mazes;  // by file name
  for (const NamedMaze& maze : race.mazes) mazes[maze.name.substr(maze.name.rfind('/') + 1)].push_back(maze.name);
  std::string lines;
  for (const auto& [file, names] : mazes)
    if (names.size() > 1 && lines.empty())
      lines = fmt::format(
          "Mazes with the same file name share their seeds, so their contests are not independent: {} and {}",
          shown(names[0]), shown(names[1]));
  const auto shared = std::count_if(mazes.begin(), mazes.end(), [](const auto& one) { return one.second.size() > 1; });
  if (lines.empty() || !uses_seeds(race)) return "";
  if (shared > 1) lines += fmt::format(", and {} more", counted(shared - 1, "name", "names"));
  return lines + ". Rename files to change that.\n";
}

/// Contests that count nowhere because the machine was too busy.
std::string unjudged_of(const Race& race) {
  const MouseColumn names(race);
  std::string lines;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    const auto count = std::count_if(race.results.begin(), race.results.end(), [&](const ContestResult& contest) {
      return contest.mouse == mouse && contest.done && !contest.judged;
    });
    if (count > 0) lines += fmt::format("  {:<{}} {}\n", names.of[mouse], names.width, count);
  }
  return lines.empty()
             ? ""
             : "Not judged, because the machine was too busy; these contests count nowhere, so race again:\n" + lines;
}

}  // namespace

std::string score_note(const World& world) {
  const auto failed = world.traits().failure_score;
  return fmt::format(
      "Score: {}; lower is better. {}\n", world.traits().formula,
      failed ? fmt::format("A failed contest counts {:g}.", *failed) : "Failed contests are left out of all means.");
}

std::string limit_note(const World& world) {
  return fmt::format("Score: {}; lower is better. A failed contest counts {:g}.\n", world.traits().formula,
                     world.traits().limit_score);
}

std::string sandbox_note(const std::vector<Contestant>& mice) {
  std::string note = freedom_note(mice);
  const auto has = [&](bool sandbox) {
    return std::any_of(mice.begin(), mice.end(), [&](const Contestant& mouse) { return mouse.sandboxed == sandbox; });
  };
  if (!has(true) || has(false)) return note;
  const bool all_hidden = std::none_of(mice.begin(), mice.end(), [](const Contestant& mouse) {
    return mouse.hidden && !mouse.hidden->unsearched().empty();
  });
  return fmt::format("External mice ran in a sandbox, without access to {}other files and the network (--sandbox).\n",
                     all_hidden ? "mazes, " : "") +
         note;
}

std::string notes_of(const Race& race) {
  std::string notes = race.world().notes(race) + failures_of(race) + sizes_of(race) + unjudged_of(race) +
                      race.world().remarks(race) + left_out_of(race) + shared_seeds_of(race);
  if (std::any_of(race.mice.begin(), race.mice.end(), [](const Contestant& mouse) { return mouse.reference; }))
    notes += "* knows the maze: attains the bound, and is not a contestant.\n";
  notes += sandbox_note(race.mice);
  if (race.stopped) {
    const auto done = std::count_if(race.results.begin(), race.results.end(),
                                    [](const ContestResult& contest) { return contest.done; });
    notes += fmt::format("Stopped early: {} of {} contests done.\n", done, race.results.size());
  }
  return notes;
}

}  // namespace labmouse
