// A world before its settings are known: what can be set of it, and how it is made.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/races/world_setting.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// A world, or why the settings make none, in lines: exactly one of the two is there.
struct WorldResult {
  std::shared_ptr<const World> world;
  std::string error;
  std::vector<std::string> remarks = {};  ///< on settings that are likely to be mistakes, a line each
};

/// Makes a world whose conditions are all in one table: `WorldOf` makes it of them.
template <const auto& Rows, auto WorldOf>
WorldResult make_by(const WorldSettings& chosen) {
  typename std::decay_t<decltype(Rows[0])>::Of conditions;
  std::string error = choose(Rows, chosen, conditions);
  return error.empty() ? WorldResult{WorldOf(conditions), ""} : WorldResult{nullptr, std::move(error)};
}

struct RecordKind;

/// What is known of a world before its settings are.
struct WorldEntry {
  std::string_view name;
  std::string_view former_name = {};  ///< in files of earlier versions and in the keys of stores; empty without one
  std::string_view summary;
  std::span<const WorldSetting> settings;
  WorldResult (*make)(const WorldSettings& settings);
  const RecordKind* records = nullptr;  ///< the kind of the records of its contests
  /// Makes the world again from an untrusted object of its conditions; returns null if they are invalid. If this
  /// pointer is null, each setting is a condition.
  std::shared_ptr<const World> (*restore)(const ReadJson& conditions) = nullptr;
  /// Default number of contests in each maze, if the mouse or the world is stochastic.
  int usual_runs = 20;
  /// Why its contests are those of one robot, behind the world's name; empty where any robot can race.
  std::string_view why_one_robot = {};
};

}  // namespace labmouse
