// A world before its settings are known: what can be set of it, and how it is made.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/text/json.hpp"

namespace labmouse {

/// Something that can be set of a world: an option of every command that holds contests.
struct WorldSetting {
  enum class Kind : std::uint8_t { text, whole, flag };

  std::string_view name;         ///< "robot" is --robot
  std::string_view placeholder;  ///< "FILE"; empty for a flag
  std::string_view meaning;
  Kind kind = Kind::text;
  std::string_view default_value;  ///< "true" or "false" for a flag
  std::int64_t low = 0, high = 0;  ///< of a whole number
  /// All values of a text that takes one of a few words; empty where it takes others, too.
  std::span<const std::string_view> choices = {};
  /// Whether a race may have several values, separated by commas: then it is held once for each.
  bool listed = false;
  /// Names of what the program brings, where it takes these and files.
  std::vector<std::string> (*brought)() = nullptr;
};

/// Settings by name; those that are not there have their defaults.
using WorldSettings = std::map<std::string, std::string, std::less<>>;

/// A world, or why the settings make none, in lines: exactly one of the two is there.
struct WorldResult {
  std::shared_ptr<const World> world;
  std::string error;
  std::vector<std::string> remarks = {};  ///< on settings that are likely to be mistakes, a line each
};

struct RecordKind;

/// What is known of a world before its settings are.
struct WorldEntry {
  std::string_view name;
  std::string_view former_name = {};  ///< in files of earlier versions and in the keys of stores; empty without one
  std::string_view summary;
  std::span<const WorldSetting> settings;
  WorldResult (*make)(const WorldSettings& settings);
  const RecordKind* records = nullptr;  ///< the kind of the records of its contests
  /// Makes the world again from an object of its conditions, of which nothing is sure; null where they are none.
  /// Without it each setting is a condition, with `_` in place of `-`.
  std::shared_ptr<const World> (*restore)(const ReadJson& conditions) = nullptr;
  /// How many contests in each maze a mouse that meets dice has, where nobody says.
  int usual_runs = 20;
};

/// The value of a setting, or its default.
std::string value_of(const WorldEntry& entry, const WorldSettings& settings, std::string_view name);
/// The same of a whole number; who takes the settings from a user checks its range.
int whole_of(const WorldEntry& entry, const WorldSettings& settings, std::string_view name);

}  // namespace labmouse
