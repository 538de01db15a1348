#include "labmouse/lab/baseline.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "labmouse/lab/standings.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::json;

/// Maze to mean penalised score, of one mouse of an earlier race.
using Scores = std::map<std::string, double>;

/// The scores of every mouse of an earlier race by its name; nothing where the JSON is not of such a race.
std::optional<std::map<std::string, Scores>> read_baseline(const Json& json, double failure_score) {
  if (!json.is_object() || !json.contains("labmouse") || !json.contains("mice") || !json["mice"].is_array()) return {};
  std::map<std::string, Scores> mice;
  for (const Json& mouse : json["mice"]) {
    if (!mouse.is_object() || !mouse.contains("name") || !mouse["name"].is_string()) return {};
    if (!mouse.contains("results") || !mouse["results"].is_array()) return {};
    std::map<std::string, std::vector<double>> runs;
    for (const Json& result : mouse["results"]) {
      if (!result.is_object() || !result.contains("maze") || !result["maze"].is_string() || !result.contains("score")) return {};
      const Json& score = result["score"];
      if (!score.is_number() && !score.is_null()) return {};
      runs[result["maze"].get<std::string>()].push_back(score.is_null() ? failure_score : score.get<double>());
    }
    Scores& scores = mice[mouse["name"].get<std::string>()];
    for (const auto& [maze, of_maze] : runs) scores[maze] = mean(of_maze);
  }
  return mice;
}

std::string compare(const Race& race, std::size_t mouse, const std::string& old_name, const Scores& old) {
  const auto scores = scores_by_maze(race, mouse);
  std::vector<double> differences;
  int better = 0, worse = 0;
  for (std::size_t maze = 0; maze < scores.size(); ++maze) {
    const auto before = old.find(race.mazes[maze].name);
    if (!scores[maze] || before == old.end()) continue;
    differences.push_back(*scores[maze] - before->second);
    better += differences.back() < 0.0 ? 1 : 0;
    worse += differences.back() > 0.0 ? 1 : 0;
  }
  const std::string name = race.mice[mouse].name == old_name ? old_name : race.mice[mouse].name + " against " + old_name;
  if (differences.empty()) return fmt::format("{}: no maze in common with the baseline\n", name);
  const Interval interval = bootstrap_interval(differences, race.order.seed);
  const char* verdict = interval.high < 0.0 ? "better" : interval.low > 0.0 ? "worse" : "no difference shown";
  return fmt::format("{}: {:+.3f} [{:+.3f}, {:+.3f}] over {} mazes ({} better, {} equal, {} worse): {}\n", name,
                     mean(differences), interval.low, interval.high, differences.size(), better,
                     static_cast<int>(differences.size()) - better - worse, worse, verdict);
}

}  // namespace

BaselineResult compare_with_baseline(const Race& race, std::string_view earlier_json) {
  const Json json = Json::parse(earlier_json, nullptr, false);
  const auto earlier = read_baseline(json, race.order.rules.failure_score);
  if (!earlier) return {"", "is not the JSON of a race (make one with `labmouse race --format json`)"};
  std::string text = "Change from the baseline (mean score over all, new - old, 95 % interval):\n";
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    auto old = earlier->find(race.mice[mouse].name);
    if (old == earlier->end() && race.mice.size() == 1 && earlier->size() == 1) old = earlier->begin();
    text += old == earlier->end() ? fmt::format("{}: not in the baseline\n", race.mice[mouse].name)
                                  : compare(race, mouse, old->first, old->second);
  }
  return {text, ""};
}

}  // namespace labmouse
