#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/hindsight/hindsight.hpp"
#include "labmouse/lab/system/version.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

std::string mazes_text(std::size_t count) { return fmt::format("{} maze{}", count, count == 1 ? "" : "s"); }

std::string best_of(const Hindsight& hindsight) { return fmt::format("best of {}", hindsight.order.others); }

std::string line_of(double bound, double score, double best_stop, const std::optional<double>& best_other,
                    std::size_t width, const std::string& name) {
  const std::string other = best_other ? fmt::format(" {:>{}.3f}", *best_other, width) : "";
  return fmt::format("{:>8.3f} {:>8.3f} {:>9.3f}{}  {}\n", bound, score, best_stop, other, name);
}

std::string others_text(const Hindsight& hindsight) {
  if (hindsight.order.others == 0) return "";
  if (!hindsight.has_others)
    return fmt::format(
        "{} has no numeric parameters to vary and makes no random choices, so it has no best of several.\n",
        hindsight.mouse);
  if (hindsight.is_stochastic)
    return fmt::format("{}: in each maze, the lowest score of its contests and of {} more seeds.\n", best_of(hindsight),
                       hindsight.order.others);
  return fmt::format(
      "{}: in each maze, the lowest score of the mouse and of {} variants, with each\n"
      "number shifted by up to a quarter.\n",
      best_of(hindsight), hindsight.order.others);
}

/// Whether in some maze the failure score is below the bound.
bool has_high_bound(const Hindsight& hindsight) {
  return std::any_of(hindsight.mazes.begin(), hindsight.mazes.end(), [&](const MazeHindsight& maze) {
    return *maze.bound.score > hindsight.order.rules.failure_score;
  });
}

std::string notes_of(const Hindsight& hindsight) {
  const Rules& rules = hindsight.order.rules;
  std::string notes =
      "No mouse can score less than the bound. The columns right of the score are\n"
      "references, not bounds: they choose in hindsight, and another mouse may score\n"
      "less.\n"
      "best stop: the mouse's own walk, reset at the best step after entering the goal,\n"
      "and the shortest route known by then; what that run would see is ignored.\n";
  notes += others_text(hindsight);
  if (hindsight.is_stochastic)
    notes += fmt::format("score, best stop: means of {} runs in each maze.\n", hindsight.order.race.runs);
  notes += fmt::format("A failed contest counts {:g}{}.\n", rules.failure_score,
                       has_high_bound(hindsight) ? ", which in some of these mazes is less than the bound" : "");
  for (const std::string& maze : hindsight.routeless)
    notes += fmt::format("Left out: {}, whose goal cannot be reached.\n", shown(maze));
  if (hindsight.stopped) notes += fmt::format("Stopped early: {} done.\n", mazes_text(hindsight.mazes.size()));
  return notes;
}

Json numbers_json(double bound, double score, double best_stop, const std::optional<double>& best_other) {
  return {{"bound", bound},
          {"score", score},
          {"best_stop", best_stop},
          {"best_other", best_other ? Json(*best_other) : Json(nullptr)}};
}

Json maze_json(const MazeHindsight& maze) {
  Json json = {{"name", maze.maze}, {"optimum", *maze.bound.optimum}};
  json.update(numbers_json(*maze.bound.score, maze.score, maze.best_stop, maze.best_other));
  json["best_mouse"] = maze.best_other ? Json(maze.best_mouse) : Json(nullptr);
  json["best_seed"] = maze.best_other ? Json(maze.best_seed) : Json(nullptr);
  return json;
}

}  // namespace

HindsightMeans means_of(const Hindsight& hindsight) {
  HindsightMeans means;
  const double count = static_cast<double>(hindsight.mazes.size());
  for (const MazeHindsight& maze : hindsight.mazes) {
    means.bound += *maze.bound.score / count;
    means.score += maze.score / count;
    means.best_stop += maze.best_stop / count;
    if (maze.best_other) means.best_other = means.best_other.value_or(0.0) + *maze.best_other / count;
  }
  return means;
}

std::string table_of(const Hindsight& hindsight, bool colours) {
  const std::size_t width = std::max<std::size_t>(9, best_of(hindsight).size());
  std::string text = fmt::format("labmouse {}: {} in hindsight, {}, seed {}\n\n", version(), hindsight.mouse,
                                 mazes_text(hindsight.mazes.size()), hindsight.order.race.seed);
  text += fmt::format("{}{:>8} {:>8} {:>9}{}  {}{}\n", colours ? "\x1b[1m" : "", "bound", "score", "best stop",
                      hindsight.has_others ? fmt::format(" {:>{}}", best_of(hindsight), width) : "", "maze",
                      colours ? "\x1b[0m" : "");
  for (const MazeHindsight& maze : hindsight.mazes)
    text += line_of(*maze.bound.score, maze.score, maze.best_stop, maze.best_other, width, shown(maze.maze));
  const HindsightMeans means = means_of(hindsight);
  if (!hindsight.mazes.empty())
    text += "\n" + line_of(means.bound, means.score, means.best_stop, means.best_other, width,
                           "mean of " + mazes_text(hindsight.mazes.size()));
  return text + "\n" + notes_of(hindsight);
}

std::string json_of(const Hindsight& hindsight) {
  Json json;
  json["labmouse"] = version();
  json["mouse"] = hindsight.mouse;
  json["is_stochastic"] = hindsight.is_stochastic;
  json["seed"] = hindsight.order.race.seed;
  json["budget"] = hindsight.order.rules.budget;
  json["runs"] = hindsight.is_stochastic ? hindsight.order.race.runs : 1;
  json["others"] = hindsight.has_others ? hindsight.order.others : 0;
  json["stopped"] = hindsight.stopped;
  json["bounds"] = {"bound"};
  json["references"] = hindsight.has_others ? Json::array({"best_stop", "best_other"}) : Json::array({"best_stop"});
  const HindsightMeans means = means_of(hindsight);
  json["means"] = hindsight.mazes.empty() ? Json(nullptr)
                                          : numbers_json(means.bound, means.score, means.best_stop, means.best_other);
  json["mazes"] = Json::array();
  for (const MazeHindsight& maze : hindsight.mazes) json["mazes"].push_back(maze_json(maze));
  json["routeless"] = hindsight.routeless;
  // Names come from the file system and may be invalid UTF-8; invalid bytes are replaced.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace labmouse
