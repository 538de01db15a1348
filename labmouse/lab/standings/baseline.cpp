#include "labmouse/lab/standings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Scores = std::map<std::string, std::vector<double>>;

constexpr double absurd = 1e6;  // no contest scores that much: whoever wrote this was no race

/// The number at the place of a score; nothing where it is null or none; `good` is false where it is no score at all.
std::optional<double> score_in(const ReadJson& result, const ScorePlace& place, bool& good) {
  const std::string key(place.key), inner(place.inner);
  good = result.is_object() && result.contains(key);
  if (!good || result[key].is_null()) return std::nullopt;
  const ReadJson& score = inner.empty()             ? result[key]
                          : result[key].is_object() ? result[key].value(inner, ReadJson())
                                                    : ReadJson();
  const double value = score.is_number() ? score.get<double>() * place.unit : absurd;
  good = value >= place.least && value < absurd;
  return good ? std::optional(value) : std::nullopt;
}

/// Reads one result of a mouse into its scores; false where it is none.
bool read_result(const ReadJson& result, const World& world, Scores& scores) {
  bool good = false;
  std::optional<double> score = score_in(result, world.score_place(), good);
  if (!good || !result.contains("maze") || !result["maze"].is_string()) return false;
  if (!score) score = world.failure_score();
  if (score) scores[result["maze"].get<std::string>()].push_back(*score);
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

bool has_conditions_of(const ReadJson& group, const World& world) {
  const auto conditions = world.conditions();
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    const auto* text = std::get_if<std::string>(&condition.value);
    const ReadJson value = text != nullptr ? ReadJson(*text) : ReadJson::parse(text_of(condition.value));
    return group.contains(condition.key) && group[condition.key] == value;
  });
}

/// The part of a race's JSON that holds a world, of several the one under the same conditions; null where there is
/// none.
const ReadJson* part_of(const ReadJson& json, const World& world) {
  if (world.is_home())
    return json["mice"].is_array() && json["mice"].empty() && json.contains("groups") ? nullptr : &json;
  if (!json.contains("groups") || !json["groups"].is_array()) return nullptr;
  const ReadJson* some = nullptr;
  for (const ReadJson& group : json["groups"]) {
    if (!group.is_object() || !group.contains("world") || group["world"] != world.name()) continue;
    if (has_conditions_of(group, world)) return &group;
    if (some == nullptr) some = &group;
  }
  return some;
}

/// A condition that differs, in a line: lists and objects by their names, where they have one.
std::string change_of(const Condition& condition, const Baseline& baseline) {
  const auto before = baseline.conditions.find(condition.key);
  if (before == baseline.conditions.end()) return "";
  const auto* text = std::get_if<std::string>(&condition.value);
  const ReadJson now = text != nullptr ? ReadJson(*text) : ReadJson::parse(text_of(condition.value));
  const ReadJson old = ReadJson::parse(before->second);
  if (old == now) return "";
  const auto name = [](const ReadJson& json) {
    const ReadJson& named = json.is_object() && json.contains("name") ? json["name"] : json;
    return shown(named.is_string() ? named.get<std::string>() : named.is_object() ? "another one" : named.dump());
  };
  if (name(old) == name(now)) return fmt::format("Warning: {} {} has changed since then.\n", condition.key, name(now));
  return fmt::format("Warning: {} was {} and is now {}.\n", condition.key, name(old), name(now));
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
    return fmt::format("{}: no mazes in common with the baseline (for example, {} here and {} there)\n", name,
                       shown(race.mazes.front().name), old.empty() ? "none" : shown(old.begin()->first));
  const PairedDifference found = paired_difference(differences, race.order.seed);
  const Interval& interval = found.interval;
  // One maze says nothing about others.
  const bool shows = found.count > 1;
  const char* verdict = shows && interval.high < 0.0  ? "better"
                        : shows && interval.low > 0.0 ? "worse"
                                                      : "no difference shown";
  return fmt::format("{}: {:+.3f} [{:+.3f}, {:+.3f}] over {} ({} better, {} equal, {} worse): {}\n", name, found.mean,
                     interval.low, interval.high, found.count == 1 ? "1 maze" : fmt::format("{} mazes", found.count),
                     found.below, found.equal, found.above, verdict);
}

}  // namespace

ReadBaselineResult read_baseline(std::string_view json_text, const World& world) {
  const auto no_race = [] {
    return ReadBaselineResult{std::nullopt, "is not the JSON of a race; create one with `labmouse race --format json`"};
  };
  const ReadJson json = read_json(json_text);
  if (json.is_discarded()) {
    const Problem problem = json_problem(json_text);
    return {std::nullopt, problem.reason, problem.line, problem.column};
  }
  if (!json.is_object() || !json.contains("labmouse") || !json.contains("mice")) return no_race();
  const ReadJson* held = part_of(json, world);
  if (held == nullptr)
    return {std::nullopt,
            fmt::format("has no race in the world {}; make one with --world {}", world.name(), world.name())};
  if (!held->contains("mice") || !(*held)["mice"].is_array()) return no_race();
  Baseline baseline;
  for (const Condition& condition : world.conditions())
    if (held->contains(condition.key)) baseline.conditions[condition.key] = (*held)[condition.key].dump();
  for (const ReadJson& mouse : (*held)["mice"]) {
    if (!mouse.is_object() || !mouse.contains("name") || !mouse["name"].is_string()) return no_race();
    if (!mouse.contains("results") || !mouse["results"].is_array()) return no_race();
    Scores& scores = baseline.mice[mouse["name"].get<std::string>()];
    for (const ReadJson& result : mouse["results"])
      if (!read_result(result, world, scores)) return no_race();
  }
  return {std::move(baseline), ""};
}

std::string compare_with_baseline(const Race& race, const Baseline& baseline) {
  std::string text = "Change from the baseline (mean score over all, new - old, 95 % interval):\n";
  for (const Condition& condition : race.world().conditions()) text += change_of(condition, baseline);
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    auto old = baseline.mice.find(race.mice[mouse].name);
    if (old == baseline.mice.end() && baseline.mice.size() == 1) old = baseline.mice.begin();
    text += old == baseline.mice.end() ? fmt::format("{}: not in the baseline\n", race.mice[mouse].name)
                                       : compare(race, mouse, old->first, old->second);
  }
  return text;
}

}  // namespace labmouse
