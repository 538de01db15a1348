// The keys of the rules of contests in seconds, with their ranges. Files of rules, records and the JSON of races read
// and write by this table.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "labmouse/contest/drive_rules.hpp"

namespace labmouse {

constexpr unsigned bit_of(Counted counted) { return 1U << static_cast<unsigned>(counted); }

struct DriveRulesKey {
  std::string_view name;  ///< in files of rules
  const char* json_name;
  /// Its type is the kind of the key. std::int64_t is a time: in seconds in files of rules, in microseconds in JSON.
  std::variant<Counted DriveRules::*, std::string DriveRules::*, std::int64_t DriveRules::*, int DriveRules::*,
               bool DriveRules::*>
      member;
  std::string_view form = {};  ///< what a value that is no number must be
  int low = 0, high = 0;       ///< of a number, in files of rules
  /// What rules with this key can count, as bits.
  unsigned with = bit_of(Counted::run) | bit_of(Counted::lap) | bit_of(Counted::dead_end);
  /// Whether rules must have it. In JSON, a number that they need not have is 0 where they lack it.
  bool needed = false;
  /// Whether JSON has it behind all others: earlier versions lacked it.
  bool later = false;

  constexpr bool goes_with(Counted counted) const { return (with & bit_of(counted)) != 0; }
  constexpr bool in_json_of(Counted counted) const { return goes_with(counted) || !needed; }
};

/// How many units of a member and of JSON are a unit of files of rules.
template <class Member>
inline constexpr std::int64_t units_of = std::is_same_v<Member, std::int64_t> ? 1'000'000 : 1;

/// All of them, in their order in JSON. What the rules count comes first, because it decides which others they have.
inline constexpr auto drive_rules_keys = std::to_array<DriveRulesKey>({
    {.name = "counts",
     .json_name = "counts",
     .member = &DriveRules::counts,
     .form = "\"run\", \"lap\" or \"dead end\"",
     .later = true},
    {.name = "source",
     .json_name = "source",
     .member = &DriveRules::source,
     .form = "where and when the rules apply, in words",
     .needed = true},
    {.name = "time_limit",
     .json_name = "time_limit",
     .member = &DriveRules::time_limit,
     .low = 1,
     .high = 7200,
     .needed = true},
    {.name = "runs",
     .json_name = "most_runs",
     .member = &DriveRules::most_runs,
     .low = 1,
     .high = 100,
     .with = bit_of(Counted::run) | bit_of(Counted::dead_end),
     .needed = true},
    {.name = "laps",
     .json_name = "most_runs",
     .member = &DriveRules::most_runs,
     .low = 1,
     .high = 20,
     .with = bit_of(Counted::lap),
     .needed = true},
    {.name = "marks",
     .json_name = "marks",
     .member = &DriveRules::marks,
     .low = 1,
     .high = 10'000,
     .with = bit_of(Counted::dead_end),
     .needed = true,
     .later = true},
    {.name = "maze_time_divisor",
     .json_name = "maze_time_divisor",
     .member = &DriveRules::maze_time_divisor,
     .low = 1,
     .high = 1000,
     .with = bit_of(Counted::run) | bit_of(Counted::lap)},
    {.name = "clock",
     .json_name = "gate_to_gate",
     .member = &DriveRules::gate_to_gate,
     .form = "\"gate to gate\" or \"rest to centre\"",
     .needed = true},
    {.name = "touch_penalty",
     .json_name = "touch_penalty",
     .member = &DriveRules::touch_penalty,
     .high = 600,
     .with = bit_of(Counted::run) | bit_of(Counted::lap)},
    {.name = "untouched_bonus",
     .json_name = "untouched_bonus",
     .member = &DriveRules::untouched_bonus,
     .high = 600,
     .with = bit_of(Counted::run) | bit_of(Counted::lap)},
});

}  // namespace labmouse
