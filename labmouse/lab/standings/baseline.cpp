#include "labmouse/lab/standings/baseline.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;
using Scores = std::map<std::string, std::vector<double>>;

constexpr double absurd = 1e6;  // no contest takes so many steps: whoever wrote this was no race

/// Reads one result of a mouse into its scores; false where it is none.
bool read_result(const Json& result, double failure_score, Scores& scores) {
  if (!result.is_object() || !result.contains("maze") || !result["maze"].is_string() || !result.contains("score"))
    return false;
  const Json& score = result["score"];
  if (!score.is_null() && !(score.is_number() && score.get<double>() >= 0.0 && score.get<double>() < absurd))
    return false;
  scores[result["maze"].get<std::string>()].push_back(score.is_null() ? failure_score : score.get<double>());
  return true;
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The scores in a maze of that name, or in the only one whose file is called so; null where there is none.
const std::vector<double>* find_scores(const Scores& scores, const std::string& maze) {
  if (const auto same = scores.find(maze); same != scores.end()) return &same->second;
  const std::vector<double>* found = nullptr;
  for (const auto& [name, values] : scores) {
    if (file_name(name) != file_name(maze)) continue;
    if (found != nullptr) return nullptr;
    found = &values;
  }
  return found;
}

std::string compare(const Race& race, std::size_t mouse, const std::string& old_name, const Scores& old) {
  const auto scores = scores_by_maze(race, mouse);
  std::vector<double> differences;
  for (std::size_t maze = 0; maze < scores.size(); ++maze) {
    const auto* before = find_scores(old, race.mazes[maze].name);
    if (!scores[maze] || before == nullptr) continue;
    differences.push_back(*scores[maze] - mean(*before));
  }
  const std::string& new_name = race.mice[mouse].name;
  const std::string name = new_name == old_name ? new_name : new_name + " against " + shown(old_name);
  if (differences.empty())
    return fmt::format("{}: no maze in common with the baseline (here {}, there {})\n", name,
                       shown(race.mazes.front().name), old.empty() ? "none" : shown(old.begin()->first));
  const PairedDifference found = paired_difference(differences, race.order.seed);
  const Interval& interval = found.interval;
  const char* verdict = interval.high < 0.0 ? "better" : interval.low > 0.0 ? "worse" : "no difference shown";
  return fmt::format("{}: {:+.3f} [{:+.3f}, {:+.3f}] over {} ({} better, {} equal, {} worse): {}\n", name, found.mean,
                     interval.low, interval.high, found.count == 1 ? "1 maze" : fmt::format("{} mazes", found.count),
                     found.below, found.equal, found.above, verdict);
}

}  // namespace

std::optional<Baseline> read_baseline(std::string_view json_text, const Rules& rules) {
  const Json json = Json::parse(json_text, nullptr, false);
  if (!json.is_object() || !json.contains("labmouse") || !json.contains("mice") || !json["mice"].is_array()) return {};
  Baseline baseline;
  if (json.contains("budget") && json["budget"].is_number_integer()) baseline.budget = json["budget"].get<int>();
  for (const Json& mouse : json["mice"]) {
    if (!mouse.is_object() || !mouse.contains("name") || !mouse["name"].is_string()) return {};
    if (!mouse.contains("results") || !mouse["results"].is_array()) return {};
    Scores& scores = baseline.mice[mouse["name"].get<std::string>()];
    for (const Json& result : mouse["results"])
      if (!read_result(result, rules.failure_score, scores)) return {};
  }
  return baseline;
}

std::string compare_with_baseline(const Race& race, const Baseline& baseline) {
  std::string text = "Change from the baseline (mean score over all, new - old, 95 % interval):\n";
  if (baseline.budget != race.order.rules.budget)
    text += fmt::format("Careful: the budget was {} steps, and is {} now.\n", baseline.budget, race.order.rules.budget);
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    auto old = baseline.mice.find(race.mice[mouse].name);
    if (old == baseline.mice.end() && baseline.mice.size() == 1) old = baseline.mice.begin();
    text += old == baseline.mice.end() ? fmt::format("{}: not in the baseline\n", race.mice[mouse].name)
                                       : compare(race, mouse, old->first, old->second);
  }
  return text;
}

}  // namespace labmouse
