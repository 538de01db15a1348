// Numbers of rules in seconds have one range each, in files of rules, in records and in the JSON of races.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/races/value_json.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/robots/drive_rules_keys.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/records/drive_record_fixture.hpp"

namespace labmouse {
namespace {

constexpr std::int64_t second = 1'000'000;  // µs

/// A range as the manual states it.
struct Range {
  std::string_view name;
  Counted counts = Counted::run;
  std::string_view json_name;
  std::int64_t low = 0, high = 0;  ///< as in JSON
  std::int64_t unit = 1;           ///< of files
  bool needed = false;             ///< if not, JSON may have a 0 instead
};

constexpr auto ranges = std::to_array<Range>({
    {.name = "time_limit",
     .json_name = "time_limit",
     .low = 1 * second,
     .high = 7200 * second,
     .unit = second,
     .needed = true},
    {.name = "runs", .json_name = "most_runs", .low = 1, .high = 100, .needed = true},
    {.name = "runs", .counts = Counted::dead_end, .json_name = "most_runs", .low = 1, .high = 100, .needed = true},
    {.name = "laps", .counts = Counted::lap, .json_name = "most_runs", .low = 1, .high = 20, .needed = true},
    {.name = "marks", .counts = Counted::dead_end, .json_name = "marks", .low = 1, .high = 10'000, .needed = true},
    {.name = "maze_time_divisor", .json_name = "maze_time_divisor", .low = 1, .high = 1000},
    {.name = "touch_penalty", .json_name = "touch_penalty", .high = 600 * second, .unit = second},
    {.name = "untouched_bonus",
     .counts = Counted::lap,
     .json_name = "untouched_bonus",
     .high = 600 * second,
     .unit = second},
});

DriveRules rules_of(Counted counted) {
  return find_rules(counted == Counted::lap ? "time-trial" : counted == Counted::dead_end ? "coverage" : "uk").rules;
}

std::string changed(std::string text, const std::string& old, const std::string& now) {
  const auto place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

/// The rules in JSON with that number.
std::string json_with(const Range& range, std::int64_t number) {
  Json json = rules_json(rules_of(range.counts));
  EXPECT_TRUE(json.contains(range.json_name)) << range.json_name;
  json[std::string(range.json_name)] = number;
  return json.dump();
}

bool file_takes(const Range& range, std::int64_t number) {
  std::string text =
      fmt::format("source = \"Ours\"\ncounts = \"{}\"\nclock = \"gate to gate\"\n", name_of(range.counts));
  if (range.name != "time_limit") text += "time_limit = 60\n";
  for (const Range& other : ranges)
    if (other.needed && other.unit == 1 && other.counts == range.counts && other.name != range.name)
      text += fmt::format("{} = 1\n", other.name);
  text += range.unit == 1 ? fmt::format("{} = {}\n", range.name, number)
                          : fmt::format("{} = {:.6f}\n", range.name, static_cast<double>(number) / second);
  const DriveRulesResult result = read_drive_rules(text, "ours");
  return result.rules && rules_json(*result.rules)[std::string(range.json_name)] == number;
}

bool record_takes(const Range& range, std::int64_t number) {
  static const DriveRecordFile file = test::driven("flood");
  static const std::string header = [] {
    const std::string text = write_drive_record(file);
    return text.substr(0, text.find('\n') + 1);
  }();
  const auto result = read_drive_record(changed(header, rules_json(file.rules).dump(), json_with(range, number)));
  return result.file && rules_json(result.file->rules).dump() == json_with(range, number);
}

bool race_takes(const Range& range, std::int64_t number) {
  const DriveRules rules = rules_of(range.counts);
  const std::string conditions = conditions_json(*seconds_world(rules, test::drive_model("mm2021"))).dump();
  const auto world = restore_world("seconds", changed(conditions, rules_json(rules).dump(), json_with(range, number)));
  return world && conditions_json(*world)["rules"].dump() == json_with(range, number);
}

TEST(RangesOfRules, AreTheSameInFilesRecordsAndRaces) {
  for (const Range& range : ranges) {
    struct Case {
      std::int64_t number;
      bool in_file, in_json;
    };
    for (const auto& [number, in_file, in_json] :
         {Case{range.low, true, true}, Case{range.high, true, true}, Case{range.high + 1, false, false},
          Case{range.low - 1, false, !range.needed && range.low == 1}, Case{-1, false, false}}) {
      SCOPED_TRACE(fmt::format("{} = {}", range.name, number));
      EXPECT_EQ(file_takes(range, number), in_file);
      EXPECT_EQ(record_takes(range, number), in_json);
      EXPECT_EQ(race_takes(range, number), in_json);
    }
  }
}

/// Each number of the table is above.
TEST(RangesOfRules, AreAllTested) {
  for (const DriveRulesKey& key : drive_rules_keys) {
    const auto is_it = [&](const Range& range) { return key.name == range.name; };
    EXPECT_EQ(std::any_of(ranges.begin(), ranges.end(), is_it), key.form.empty()) << key.name;
  }
}

}  // namespace
}  // namespace labmouse
