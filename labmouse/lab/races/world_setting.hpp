// The settings of a world as a table: each row says what can be set, in what range, and which member of the world's
// conditions it is. The command line, the page, JSON, stores, records and the reference read and write by it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "labmouse/functions/named_number.hpp"
#include "labmouse/lab/races/figures.hpp"
#include "labmouse/lab/races/value.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {

/// Something that can be set of a world: an option of every command that runs contests.
struct WorldSetting {
  enum class Kind : std::uint8_t { text, whole, flag, number };

  std::string_view name;              ///< "search-speed" is --search-speed, and "search_speed" in JSON
  std::string_view placeholder = {};  ///< "FILE", or the unit; empty for a flag, and where there are `choices`
  std::string_view meaning;
  std::string_view default_value;  ///< "true" or "false" for a flag
  double low = 0.0, high = 0.0;    ///< of a number
  /// All values of a text that takes one of a few words; empty where it takes others, too.
  std::span<const std::string_view> choices = {};
  /// Values of a number that may be chosen by name.
  std::span<const NamedNumber> named = {};
  /// Whether a race may have several values, separated by commas: then it is run once for each.
  bool listed = false;
  /// Names of the built-in values, if the setting takes such a name or a file.
  std::vector<std::string> (*brought)() = nullptr;
  /// If it is above `low`, users can choose only `low` itself and numbers from `least_chosen` on; files of earlier
  /// versions can have others.
  double least_chosen = 0.0;
  std::string_view unit = {};  ///< of such a number
  /// The default of a race in which all mazes are half-size; empty if it is the same.
  std::string_view half_size_default = {};
  /// Whether files of earlier versions lack it; they mean the default.
  bool later = false;
  Kind kind = Kind::text;  ///< row() takes it from the member
};

/// Settings by name; those that are not there have their defaults.
using WorldSettings = std::map<std::string, std::string, std::less<>>;

/// The value that a user chose; or what is wrong with the text, in `error`, as in "'x' is not a number from 0 to 1".
Value chosen_value(const WorldSetting& setting, const std::string& text, std::string& error);
/// The value in an untrusted file; errors are reported to `fields`.
Value read_value(const WorldSetting& setting, JsonFields& fields);
/// The numbers that a user can choose, such as "0 to 100" or "0, or 10 to 20000 mm/s".
std::string range_of(const WorldSetting& setting);
/// The setting's key in JSON.
std::string key_of(const WorldSetting& setting);
/// The text of one of these settings, or its default.
std::string text_of(std::span<const WorldSetting> all, const WorldSettings& chosen, std::string_view name);

/// A row: a setting, and the member of a world's conditions that it is.
template <class Conditions>
struct SettingRow {
  using Of = Conditions;

  WorldSetting setting;
  Value (*of)(const Conditions&);
  void (*set)(const Value&, Conditions&);
};

/// The member behind a path of members.
template <class Struct, class Member, class... Members>
constexpr auto& member_at(Struct& conditions, Member first, Members... rest) {
  if constexpr (sizeof...(rest) == 0)
    return conditions.*first;
  else
    return member_at(conditions.*first, rest...);
}

template <class Member>
constexpr WorldSetting::Kind kind_of = std::is_same_v<Member, bool>     ? WorldSetting::Kind::flag
                                       : std::is_same_v<Member, int>    ? WorldSetting::Kind::whole
                                       : std::is_same_v<Member, double> ? WorldSetting::Kind::number
                                                                        : WorldSetting::Kind::text;

/// The setting that is the member behind a path of members.
template <auto First, auto... Rest>
constexpr auto row(WorldSetting setting) {
  using Conditions = decltype(struct_of(First));
  setting.kind = kind_of<std::decay_t<decltype(member_at(std::declval<Conditions&>(), First, Rest...))>>;
  return SettingRow<Conditions>{
      setting, [](const Conditions& conditions) { return value_of(member_at(conditions, First, Rest...)); },
      [](const Value& value, Conditions& conditions) { set_to(value, member_at(conditions, First, Rest...)); }};
}

/// The settings of a table, for the entry of its world.
template <const auto& Rows>
inline constexpr auto settings_of = [] {
  std::array<WorldSetting, Rows.size()> settings;
  for (std::size_t i = 0; i < Rows.size(); ++i) settings[i] = Rows[i].setting;
  return settings;
}();

/// Sets the conditions to what a user chose, or to the defaults; returns what is wrong, for the user.
template <class Rows, class Conditions>
std::string choose(const Rows& rows, const WorldSettings& chosen, Conditions& conditions) {
  for (const auto& [setting, of, set] : rows) {
    std::string error;
    const Value value = chosen_value(setting, text_of({&setting, 1}, chosen, setting.name), error);
    if (!error.empty()) return "error: --" + std::string(setting.name) + ": " + error;
    set(value, conditions);
  }
  return "";
}

/// Sets the conditions to the values in a file; errors are reported to `fields`.
template <class Rows, class Conditions>
void read_settings(const Rows& rows, JsonFields& fields, Conditions& conditions) {
  for (const auto& [setting, of, set] : rows) {
    if (setting.later && !fields.has(key_of(setting).c_str())) continue;
    const Value value = read_value(setting, fields);
    if (fields.error().empty()) set(value, conditions);
  }
}

}  // namespace labmouse
