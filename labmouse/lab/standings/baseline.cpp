#include "labmouse/lab/standings/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/text/counted.hpp"
#include "labmouse/lab/text/json.hpp"
#include "labmouse/lab/text/json_problem.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

using Scores = std::map<std::string, MazeScores>;

constexpr double absurd = 1e6;  // above any score of a contest: such a file is not the JSON of a race

/// The score of a result; nothing if it is null. Sets `good` to false if there is no field of the score or its value is
/// invalid.
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
  const std::optional<double> score = score_in(result, world.traits().score_place, good);
  if (!good || !result.contains("maze") || !result["maze"].is_string()) return false;
  scores[result["maze"].get<std::string>()].add(score, score.value_or(world.traits().limit_score));
  return true;
}

std::string file_name(const std::string& path) { return path.substr(path.rfind('/') + 1); }

/// The scores in a maze of that name, or in the only one whose file is called so; null where there is none.
const MazeScores* find_scores(const Scores& scores, const std::string& maze) {
  if (const auto same = scores.find(maze); same != scores.end()) return &same->second;
  const MazeScores* found = nullptr;
  for (const auto& [name, values] : scores) {
    if (file_name(name) != file_name(maze)) continue;
    if (found != nullptr) return nullptr;
    found = &values;
  }
  return found;
}

bool has_conditions_of(const ReadJson& group, const World& world) {
  const auto& conditions = world.traits().conditions;
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    const auto* text = std::get_if<std::string>(&condition.value);
    const ReadJson value = text != nullptr ? ReadJson(*text) : ReadJson::parse(text_of(condition.value));
    return group.contains(condition.key) && group[condition.key] == value;
  });
}

/// The race in that world under the same conditions; otherwise the first one in that world; null if there is none.
const ReadJson* part_of(const ReadJson& json, const World& world) {
  const ReadJson* some = nullptr;
  for (const ReadJson& group : json["groups"]) {
    if (!group.is_object() || !group.contains("world") || group["world"] != world.traits().name) continue;
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

/// A mouse of the race and the one of the baseline that it is compared with.
struct Match {
  std::size_t mouse = 0;
  std::string old_name;
  MousePair pair;
};

MousePair pair_with(const Race& race, std::size_t mouse, const Scores& old) {
  std::vector<MazeScores> before;
  for (const NamedMaze& maze : race.mazes) {
    const MazeScores* found = find_scores(old, maze.name);
    before.push_back(found != nullptr ? *found : MazeScores());
  }
  return pair_of(maze_scores(race, mouse), before, !race.world().traits().failure_score, race.order.seed);
}

std::string name_of(const Race& race, const Match& match) {
  const std::string& name = race.mice[match.mouse].name;
  return name == match.old_name ? name : name + " against " + shown(match.old_name);
}

/// "-0.205 [-1.733, +1.337] over 43 mazes (16 better, 3 equal, 24 worse)", with the numbers times a factor.
std::string difference_text(const PairedDifference& found, double factor, int digits) {
  const Interval ends = scaled(found.interval, factor);  // + 0.0 turns -0.0 into 0
  const std::string interval =
      found.count > 1 ? fmt::format(" [{:+.{}f}, {:+.{}f}]", ends.low + 0.0, digits, ends.high + 0.0, digits) : "";
  return fmt::format("{:+.{}f}{} over {} ({} better, {} equal, {} worse)", factor * found.mean + 0.0, digits, interval,
                     counted(found.count, "maze", "mazes"), found.below, found.equal, found.above);
}

std::string lines_of(const Race& race, const Match& match, const PairVerdicts& verdicts) {
  const std::string name = name_of(race, match);
  const MousePair& pair = match.pair;
  std::string text = fmt::format("{}: {}: {}\n", name, difference_text(pair.scores, 1.0, 3), name_of(verdicts.scores));
  if (!pair.has_rates) return text;
  const FinishRates& rates = pair.rates;
  text += fmt::format("{}, finished: {} of {} contests, before {} of {}; in percent {}: {}\n", name,
                      rates.mouse.finished, rates.mouse.contests, rates.against.finished, rates.against.contests,
                      difference_text(rates.failed, -100.0, 1), name_of(verdicts.rates));
  if (rates.finished_only.count > 0)
    text +=
        fmt::format("{}, only the contests that finished: {}\n", name, difference_text(rates.finished_only, 1.0, 3));
  return text;
}

std::string nothing_in_common(const Race& race, const Match& match, const Scores& old) {
  return fmt::format("{}: no mazes in common with the baseline (for example, {} here and {} there)\n",
                     name_of(race, match), shown(race.mazes.front().name),
                     old.empty() ? "none" : shown(old.begin()->first));
}

/// What differences are of.
std::string heading_of(const World& world) {
  const std::string failures =
      world.traits().failure_score
          ? ""
          : fmt::format(", failed contests at {:g} {}", world.traits().limit_score, world.traits().unit);
  return fmt::format("Change from the baseline (mean score over all{}, new - old, 95 % interval):\n", failures);
}

}  // namespace

ReadBaselineResult read_baseline(std::string_view json_text, const World& world) {
  const auto no_race = [] {
    return ReadBaselineResult{std::nullopt, "is not the JSON of a race; create one with `labmouse race --format json`"};
  };
  const ReadJson json = with_groups(read_json(json_text));
  if (json.is_discarded()) {
    const Problem problem = json_problem(json_text);
    return {std::nullopt, problem.reason, problem.line, problem.column};
  }
  if (!json.is_object() || !json.contains("labmouse") || !json.contains("groups") || !json["groups"].is_array())
    return no_race();
  const ReadJson* held = part_of(json, world);
  if (held == nullptr)
    return {std::nullopt, fmt::format("has no race in the world {}; make one with --world {}", world.traits().name,
                                      world.traits().name)};
  if (!held->contains("mice") || !(*held)["mice"].is_array()) return no_race();
  Baseline baseline;
  for (const Condition& condition : world.traits().conditions)
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
  std::string text = heading_of(race.world());
  for (const Condition& condition : race.world().traits().conditions) text += change_of(condition, baseline);
  std::vector<Match> matches;
  std::string missing;
  for (std::size_t mouse = 0; mouse < race.mice.size(); ++mouse) {
    auto old = baseline.mice.find(race.mice[mouse].name);
    if (old == baseline.mice.end() && baseline.mice.size() == 1) old = baseline.mice.begin();
    if (old == baseline.mice.end()) {
      missing += fmt::format("{}: not in the baseline\n", race.mice[mouse].name);
      continue;
    }
    Match match = {mouse, old->first, pair_with(race, mouse, old->second)};
    if (match.pair.scores.count == 0)
      missing += nothing_in_common(race, match, old->second);
    else
      matches.push_back(std::move(match));
  }
  std::vector<MousePair> pairs;
  for (const Match& match : matches) pairs.push_back(match.pair);
  const std::vector<PairVerdicts> verdicts = verdicts_of(pairs);
  text += verdict_notes(judged(pairs)) + missing;
  for (std::size_t i = 0; i < matches.size(); ++i) text += lines_of(race, matches[i], verdicts[i]);
  return text;
}

}  // namespace labmouse
