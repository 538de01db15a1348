#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/studies/compare.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string source_text(const MazeSource& source) {
  if (!source.list.empty()) return fmt::format("{} of a list", counted(source.list.size(), "maze", "mazes"));
  return fmt::format("generated mazes ({}, {}x{})", source.generator->name, source.order.size.width,
                     source.order.size.height);
}

std::string line_of(const ComparedMouse& candidate, std::size_t width) {
  return fmt::format("{:<{}} {:>8} {:>7.3f} {:>7.3f} {:>+11.4f}  {:>+8.4f} to {:>+7.4f}  {}\n", shown(candidate.mouse),
                     width, candidate.pairs, candidate.share, candidate.first_share, candidate.difference,
                     candidate.interval.low, candidate.interval.high, name_of(candidate.verdict));
}

std::string percent(double share) { return fmt::format("{:g} %", share * 100.0); }

/// What the verdicts mean.
std::string notes_of(const Compared& compared) {
  const SequentialOrder& test = compared.order.test;
  if (compared.mazes == compared.skipped) return "";
  if (compared.exact)
    return "Nothing here is stochastic, and each maze of the list was raced in: there the differences are exact.\n";
  const std::string_view bounds = test.method == SequentialMethod::bets ? "at most" : "about";
  std::string text = fmt::format(
      "better, worse: wrong with a probability of {0} {1}{2}\nno difference: none of {3:g} or more, wrong with {0} "
      "{4}{2}\n",
      bounds, percent(test.alpha), compared.candidates.size() > 1 ? ", for all together" : "", test.better_by,
      percent(test.beta));
  const bool any =
      std::any_of(compared.candidates.begin(), compared.candidates.end(),
                  [](const ComparedMouse& candidate) { return candidate.verdict == SequentialVerdict::undecided; });
  if (any && compared.mazes > compared.skipped && !compared.stopped)
    text += fmt::format("undecided: {} were not enough; more may decide.\n", counted(compared.mazes, "maze", "mazes"));
  return text;
}

Json source_json(const MazeSource& source) {
  if (source.list.empty())
    return {{"generator", source.generator->name},
            {"width", source.order.size.width},
            {"height", source.order.size.height},
            {"loops", source.order.loops / 1000.0}};
  Json names = Json::array();
  for (const NamedMaze& maze : source.list) names.push_back(maze.name);
  return {{"list", std::move(names)}};
}

}  // namespace

std::string table_of(const Compared& compared) {
  const World& world = *compared.order.race.world;
  std::size_t width = 9;
  for (const ComparedMouse& candidate : compared.candidates) width = std::max(width, shown(candidate.mouse).size());
  std::string text = fmt::format("labmouse {}, {}seed {}{}\n", version(), world.title(), compared.order.race.seed,
                                 world.traits().heading);
  text += fmt::format("Share of the best possible score against {}, in {}\n\n", shown(compared.first),
                      source_text(compared.order.mazes));
  text += fmt::format(
      "{:<{}} {:>8} {:>7} {:>7} {:>11}  {:>19}  {}\n", "candidate", width, "mazes", "share", "first", "difference",
      compared.exact && compared.mazes > compared.skipped ? "exact"
                                                          : percent(1.0 - compared.order.test.alpha) + " interval",
      "verdict");
  for (const ComparedMouse& candidate : compared.candidates) text += line_of(candidate, width);
  text += "\n" + notes_of(compared);
  if (compared.skipped > 0)
    text += fmt::format("{} did not count: no mouse can score in them, or a contest was not judged.\n",
                        counted(compared.skipped, "maze", "mazes"));
  return text;
}

Json comparison_json(const Compared& compared) {
  const World& world = *compared.order.race.world;
  const SequentialOrder& test = compared.order.test;
  Json json = {{"labmouse", version()},
               {"world", world.traits().name},
               {"conditions", conditions_json(world)},
               {"seed", compared.order.race.seed},
               {"mazes", source_json(compared.order.mazes)},
               {"method", test.method == SequentialMethod::bets ? "bets" : "gsprt"},
               {"better_by", test.better_by},
               {"alpha", test.alpha},
               {"beta", test.beta},
               {"most", compared.order.most},
               {"raced_in", compared.mazes},
               {"skipped", compared.skipped},
               {"exact", compared.exact},
               {"stopped", compared.stopped},
               {"first", compared.first},
               {"candidates", Json::array()}};
  for (const ComparedMouse& candidate : compared.candidates)
    json["candidates"].push_back({{"mouse", candidate.mouse},
                                  {"verdict", name_of(candidate.verdict)},
                                  {"pairs", candidate.pairs},
                                  {"share", candidate.share},
                                  {"first_share", candidate.first_share},
                                  {"difference", candidate.difference},
                                  {"interval", {candidate.interval.low, candidate.interval.high}}});
  return json;
}

std::string json_of(const Compared& compared) { return text_of(comparison_json(compared)); }

}  // namespace labmouse
