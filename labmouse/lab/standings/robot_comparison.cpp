#include "labmouse/lab/standings/robot_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "labmouse/lab/standings/mouse_column.hpp"
#include "labmouse/lab/standings/mouse_pair.hpp"
#include "labmouse/lab/standings/pair_report.hpp"
#include "labmouse/lab/standings/race_names.hpp"
#include "labmouse/lab/standings/standings.hpp"
#include "labmouse/lab/text/printable.hpp"

namespace labmouse {
namespace {

/// Races that differ only in their robots.
using Group = std::vector<const Race*>;

/// World and conditions besides the robot and the tables that follow from it.
std::string other_conditions(const World& world) {
  std::string text(world.traits().name);
  for (const Condition& condition : world.traits().conditions)
    if (condition.key != "robot" && condition.key != "tables")
      text += fmt::format("\n{} {}", condition.key, text_of(condition.value));
  return text;
}

std::vector<Group> groups_of(std::span<const Race> races) {
  std::vector<std::pair<std::string, Group>> by_conditions;
  for (const Race& race : races) {
    if (robot_name(race.world()).empty()) continue;
    const std::string conditions = other_conditions(race.world());
    auto found = std::find_if(by_conditions.begin(), by_conditions.end(),
                              [&](const auto& one) { return one.first == conditions; });
    if (found == by_conditions.end()) found = by_conditions.insert(found, {conditions, {}});
    found->second.push_back(&race);
  }
  std::vector<Group> groups;
  for (auto& [conditions, group] : by_conditions)
    if (group.size() > 1) groups.push_back(std::move(group));
  return groups;
}

/// The pairs of all mice, in the order of the first robot's leaderboard: each robot but the first with the first one.
std::vector<MousePair> pairs_of(const Group& group, const std::vector<Standing>& order) {
  // Only the scores are compared: with a verdict on finished contests, too, the table would be no short one.
  constexpr bool has_rates = false;
  std::vector<MousePair> pairs;
  for (const Standing& standing : order)
    for (std::size_t robot = 1; robot < group.size(); ++robot)
      pairs.push_back(pair_of(maze_scores(*group[robot], standing.mouse), maze_scores(*group[0], standing.mouse),
                              has_rates, group[0]->order.seed));
  return pairs;
}

std::string result_text(const Race& race, std::size_t mouse) {
  const std::vector<Standing> standings = standings_of(race);
  const auto found =
      std::find_if(standings.begin(), standings.end(), [&](const Standing& each) { return each.mouse == mouse; });
  return fmt::format("{:>9} {:>8}", fmt::format("{}/{}", found->finished, found->runs),
                     found->mean_at_limit ? fmt::format("{:.3f}", *found->mean_at_limit) : "-");
}

std::string table_of(const Group& group) {
  const Race& first = *group.front();
  const MouseColumn names(first);
  std::vector<std::string> robots;
  std::size_t width = 5;
  for (const Race* race : group) width = std::max(width, robots.emplace_back(robot_name(race->world())).size());
  const std::vector<Standing> order = standings_of(first);
  const std::vector<MousePair> pairs = pairs_of(group, order);
  const std::vector<PairVerdicts> verdicts = verdicts_of(pairs);
  std::string text = fmt::format("Robots compared with {} in the same mazes{}\n{:<{}} {:<{}} {:>9} {:>8}{}\n",
                                 robots.front(), first.world().traits().heading, "mouse", names.width, "robot", width,
                                 "finished", "mean", difference_heading());
  std::size_t next = 0;
  for (const Standing& standing : order)
    for (std::size_t robot = 0; robot < group.size(); ++robot) {
      text += fmt::format("{:<{}} {:<{}} {}", robot == 0 ? names.of[standing.mouse] : "", names.width, robots[robot],
                          width, result_text(*group[robot], standing.mouse));
      if (robot > 0) text += difference_columns(pairs[next].scores, verdicts[next].scores);
      next += robot > 0 ? 1 : 0;
      text += "\n";
    }
  return text + verdict_notes(judged(pairs));
}

}  // namespace

std::string compare_robots(std::span<const Race> races) {
  std::string text;
  for (const Group& group : groups_of(races)) text += (text.empty() ? "" : "\n") + table_of(group);
  if (text.empty()) return "";
  const World& world = races.back().world();
  return fmt::format(
      "{}In {}; a failed contest counts {:g}. A difference below 0 means that the robot is better than the first "
      "one.\n",
      text, world.traits().unit, world.traits().limit_score);
}

}  // namespace labmouse
