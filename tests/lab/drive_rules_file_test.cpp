// Rules of contests in seconds as files: what is read, and what is said of a file that is none.
#include "labmouse/lab/robots/drive_rules_file.hpp"

#include <gtest/gtest.h>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"

namespace labmouse {
namespace {

constexpr std::string_view whole =
    "source = \"Ours, 2026\"\n"
    "time_limit = 420.5\n"
    "runs = 7\n"
    "maze_time_divisor = 20\n"
    "touch_penalty = 2.5\n"
    "untouched_bonus = 4\n"
    "clock = \"rest to centre\"\n";

/// The text with its only `from` replaced.
std::string changed(std::string_view from, std::string_view to) {
  std::string result(whole);
  const auto at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return result.replace(at, from.size(), to);
}

/// What is said of it, a line a problem.
std::string complaint(std::string_view text) {
  const DriveRulesResult result = read_drive_rules(text, "my.toml");
  EXPECT_NE(result.rules.has_value(), !result.problems.empty());
  std::string lines;
  for (const Problem& problem : result.problems) lines += describe("my.toml", problem) + "\n";
  return lines;
}

TEST(DriveRulesFile, IsRead) {
  const DriveRulesResult result = read_drive_rules(whole, "ours");
  ASSERT_TRUE(result.rules) << complaint(whole);
  EXPECT_EQ(result.rules->name, "ours");
  EXPECT_EQ(result.rules->source, "Ours, 2026");
  EXPECT_EQ(result.rules->time_limit, 420'500'000);
  EXPECT_EQ(result.rules->most_runs, 7);
  EXPECT_EQ(result.rules->maze_time_divisor, 20);
  EXPECT_EQ(result.rules->touch_penalty, 2'500'000);
  EXPECT_EQ(result.rules->untouched_bonus, 4'000'000);
  EXPECT_FALSE(result.rules->gate_to_gate);
}

TEST(DriveRulesFile, MayLeaveOutWhatDoesNotCount) {
  const DriveRulesResult result =
      read_drive_rules("source = \"Ours\"\ntime_limit = 300\nruns = 5\nclock = \"gate to gate\"\n", "ours");
  ASSERT_TRUE(result.rules);
  EXPECT_EQ(result.rules->maze_time_divisor, 0);
  EXPECT_EQ(result.rules->touch_penalty, 0);
  EXPECT_EQ(result.rules->untouched_bonus, 0);
  EXPECT_TRUE(result.rules->gate_to_gate);
}

TEST(DriveRulesFile, SaysWhatIsMissing) {
  EXPECT_EQ(complaint(""),
            "my.toml: error: missing key 'source': where and when the rules were in force, in words\n"
            "my.toml: error: missing key 'time_limit': a number of seconds from 1 to 7200\n"
            "my.toml: error: missing key 'runs': a whole number from 1 to 100\n"
            "my.toml: error: missing key 'clock': \"gate to gate\" or \"rest to centre\"\n");
}

TEST(DriveRulesFile, SaysWhatIsWrong) {
  EXPECT_EQ(complaint(changed("runs = 7", "runs = 7.5")),
            "my.toml:3:8: error: 'runs' must be a whole number from 1 to 100\n");
  EXPECT_EQ(complaint(changed("420.5", "0")),
            "my.toml:2:14: error: 'time_limit' must be a number of seconds from 1 to 7200\n");
  EXPECT_EQ(complaint(changed("420.5", "nan")),
            "my.toml:2:14: error: 'time_limit' must be a number of seconds from 1 to 7200\n");
  EXPECT_EQ(complaint(changed("420.5", "\"long\"")),
            "my.toml:2:14: error: 'time_limit' must be a number of seconds from 1 to 7200\n");
  EXPECT_EQ(complaint(changed("rest to centre", "noon")),
            "my.toml:7:9: error: 'clock' must be \"gate to gate\" or \"rest to centre\"\n");
  EXPECT_EQ(complaint(changed("\"rest to centre\"", "3")),
            "my.toml:7:9: error: 'clock' must be \"gate to gate\" or \"rest to centre\"\n");
  EXPECT_EQ(complaint(changed("\"Ours, 2026\"", "\"\"")),
            "my.toml:1:10: error: 'source' must be where and when the rules were in force, in words\n");
  EXPECT_EQ(complaint(changed("maze_time_divisor = 20", "maze_time_divisor = 0")),
            "my.toml:4:21: error: 'maze_time_divisor' must be a whole number from 1 to 1000\n");
}

TEST(DriveRulesFile, SaysWhatItDoesNotKnow) {
  EXPECT_EQ(complaint(changed("touch_penalty", "touch_penality")),
            "my.toml:5:1: error: unknown key 'touch_penality'; did you mean 'touch_penalty'?\n");
  EXPECT_EQ(complaint(std::string(whole) + "[weather]\nrain = true\n").substr(0, 37),
            "my.toml:8:2: error: unknown key 'weat");
}

TEST(DriveRulesFile, PassesOnWhatIsNoToml) {
  EXPECT_EQ(complaint("runs 5\n").substr(0, 14), "my.toml:1:6: e");
  EXPECT_EQ(complaint(std::string(70'000, '#')), "my.toml: error: has 70000 bytes; more than 65536 is too large\n");
}

TEST(Rules, ComeWithTheProgram) {
  std::vector<std::string_view> names;
  for (const BuiltinRules& rules : builtin_rules()) names.push_back(rules.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"all-japan", "apec", "thirtieth", "uk"}));
  for (const std::string_view name : names) {
    const FoundRules found = find_rules(std::string(name));
    EXPECT_TRUE(found.errors.empty()) << name;
    EXPECT_EQ(found.rules.name, name);
    EXPECT_NE(found.rules.source, "");
    EXPECT_EQ(found.rules.maze_time_divisor, name == "all-japan" ? 0 : 30);
  }
}

TEST(Rules, OfAnotherNameAreUnknown) {
  EXPECT_EQ(find_rules("all-japn").errors,
            (std::vector<std::string>{"error: unknown rules 'all-japn'; did you mean 'all-japan'?"}));
  ASSERT_EQ(find_rules("nowhere/rules.toml").errors.size(), 1U);
  EXPECT_EQ(find_rules("nowhere/rules.toml").errors[0], "nowhere/rules.toml: error: no such file");
}

TEST(Rules, MayBeAFile) {
  const std::string path = LABMOUSE_SOURCE_DIR "/rules/thirtieth.toml";
  const FoundRules found = find_rules(path);
  EXPECT_TRUE(found.errors.empty());
  EXPECT_EQ(found.rules.name, path);
  EXPECT_EQ(found.rules.time_limit, 600'000'000);
}

}  // namespace
}  // namespace labmouse
