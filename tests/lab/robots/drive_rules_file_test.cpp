// Rules of contests in seconds as files: what is read, and what is said of a file that is none.
#include "labmouse/lab/robots/drive_rules_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_rules.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::Contains;
using ::testing::ElementsAre;

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

/// What is said of it.
std::vector<std::string> complaints(std::string_view text) {
  const DriveRulesResult result = read_drive_rules(text, "my.toml");
  EXPECT_NE(result.rules.has_value(), !result.problems.empty());
  std::vector<std::string> lines;
  for (const Problem& problem : result.problems) lines.push_back(describe("my.toml", problem));
  return lines;
}

TEST(DriveRulesFile, IsRead) {
  const DriveRulesResult result = read_drive_rules(whole, "ours");
  ASSERT_TRUE(result.rules) << testing::PrintToString(complaints(whole));
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
  EXPECT_THAT(complaints(""),
              ElementsAre(SaysAt("my.toml", "missing", "'source'"),
                          SaysAt("my.toml", "missing", "'time_limit'", "seconds", "1 to 7200"),
                          SaysAt("my.toml", "missing", "'runs'", "whole number", "1 to 100"),
                          SaysAt("my.toml", "missing", "'clock'", "\"gate to gate\"", "\"rest to centre\"")));
}

TEST(DriveRulesFile, SaysWhatIsWrong) {
  EXPECT_THAT(complaints(changed("runs = 7", "runs = 7.5")),
              ElementsAre(SaysAt("my.toml:3:8", "'runs'", "whole number", "1 to 100")));
  for (const char* limit : {"0", "nan", "\"long\""})
    EXPECT_THAT(complaints(changed("420.5", limit)),
                ElementsAre(SaysAt("my.toml:2:14", "'time_limit'", "seconds", "1 to 7200")));
  for (const char* clock : {"\"noon\"", "3"})
    EXPECT_THAT(complaints(changed("\"rest to centre\"", clock)),
                ElementsAre(SaysAt("my.toml:7:9", "'clock'", "\"gate to gate\"", "\"rest to centre\"")));
  EXPECT_THAT(complaints(changed("\"Ours, 2026\"", "\"\"")), ElementsAre(SaysAt("my.toml:1:10", "'source'")));
  EXPECT_THAT(complaints(changed("maze_time_divisor = 20", "maze_time_divisor = 0")),
              ElementsAre(SaysAt("my.toml:4:21", "'maze_time_divisor'", "whole number", "1 to 1000")));
}

TEST(DriveRulesFile, MayCountLaps) {
  const std::string laps = "source = \"Ours\"\ncounts = \"lap\"\ntime_limit = 60\nlaps = 3\n";
  const DriveRulesResult result = read_drive_rules(laps + "clock = \"gate to gate\"\n", "ours");
  ASSERT_TRUE(result.rules);
  EXPECT_EQ(result.rules->counts, Counted::lap);
  EXPECT_EQ(result.rules->most_runs, 3);
  EXPECT_THAT(complaints(laps + "clock = \"rest to centre\"\n"),
              ElementsAre(SaysAt("my.toml:5:9", "'clock'", "\"gate to gate\"", "\"lap\"")));
  EXPECT_THAT(complaints(laps + "clock = \"gate to gate\"\nruns = 5\n"),
              ElementsAre(SaysAt("my.toml:6:8", "'runs'", "\"lap\"", "remove")));
  EXPECT_THAT(complaints(changed("runs = 7", "runs = 7\nlaps = 5")),
              ElementsAre(SaysAt("my.toml:4:8", "'laps'", "\"run\"", "remove")));
  EXPECT_THAT(complaints(changed("runs = 7", "counts = \"lap\"\nlaps = 21")),
              ElementsAre(SaysAt("my.toml:4:8", "'laps'", "1 to 20"), SaysAt("my.toml:8:9", "'clock'")));
  EXPECT_EQ(read_drive_rules(changed("runs = 7", "counts = \"run\"\nruns = 7"), "ours").rules->counts, Counted::run);
  EXPECT_THAT(complaints(changed("runs = 7", "counts = \"goal\"\nruns = 7")),
              ElementsAre(SaysAt("my.toml:3:10", "'counts'", "\"run\"", "\"lap\"", "\"dead end\"")));
  for (const char* wrong : {"\"\"", "7"})
    EXPECT_THAT(complaints(changed("runs = 7", std::string("counts = ") + wrong + "\nlaps = 7\nmarks = 3")),
                ElementsAre(SaysAt("my.toml:3:10", "'counts'")));
}

TEST(DriveRulesFile, SaysWhatItDoesNotKnow) {
  EXPECT_THAT(complaints(changed("touch_penalty", "touch_penality")),
              ElementsAre(SaysAt("my.toml:5:1", "unknown", "'touch_penality'", "'touch_penalty'")));
  EXPECT_THAT(complaints(std::string(whole) + "[weather]\nrain = true\n"),
              Contains(SaysAt("my.toml:8:2", "unknown", "'weather'")));
}

TEST(DriveRulesFile, PassesOnWhatIsNoToml) {
  EXPECT_THAT(complaints("runs 5\n"), Contains(SaysAt("my.toml:1:6")));
  EXPECT_THAT(complaints(std::string(70'000, '#')), ElementsAre(SaysAt("my.toml", "70000 bytes", "65536")));
}

TEST(Rules, ComeWithTheProgram) {
  std::vector<std::string_view> names;
  for (const BuiltinRules& rules : builtin_rules()) names.push_back(rules.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"aamc", "all-japan", "all-japan-freshmen", "all-japan-half",
                                                  "all-japan-heats", "apec", "coverage", "ieee-r6", "portugal",
                                                  "taiwan", "thirtieth", "time-trial", "uk", "uk-2018"}));
  for (const std::string_view name : names) {
    const FoundRules found = find_rules(std::string(name));
    EXPECT_TRUE(found.errors.empty()) << name;
    EXPECT_EQ(found.rules.name, name);
    EXPECT_NE(found.rules.source, "");
  }
}

/// As the organisers have published them; the files name the pages.
TEST(Rules, AreThoseOfTheOrganisers) {
  struct Published {
    const char* name;
    int minutes, runs, divisor, touch;
  };
  for (const Published& contest :
       {Published{"all-japan", 5, 5, 0, 0}, Published{"all-japan-half", 10, 5, 0, 0}, Published{"apec", 7, 5, 30, 2},
        Published{"thirtieth", 10, 100, 30, 0}, Published{"uk", 5, 5, 0, 0}, Published{"uk-2018", 10, 100, 30, 3}}) {
    SCOPED_TRACE(contest.name);
    const DriveRules rules = find_rules(contest.name).rules;
    EXPECT_EQ(rules.time_limit, 60'000'000LL * contest.minutes);
    EXPECT_EQ(rules.most_runs, contest.runs);
    EXPECT_EQ(rules.maze_time_divisor, contest.divisor);
    EXPECT_EQ(rules.touch_penalty, 1'000'000LL * contest.touch);
    EXPECT_EQ(rules.untouched_bonus, 0);
    EXPECT_TRUE(rules.gate_to_gate);
  }
}

TEST(Rules, OfTimeTrialsCountLaps) {
  const DriveRules rules = find_rules("time-trial").rules;
  EXPECT_EQ(rules.counts, Counted::lap);
  EXPECT_EQ(rules.most_runs, 5);
  EXPECT_EQ(rules.time_limit, 180'000'000);
  EXPECT_EQ(rules.maze_time_divisor + rules.touch_penalty + rules.untouched_bonus, 0);
  EXPECT_EQ(find_rules("uk").rules.counts, Counted::run);
}

TEST(Rules, OfAnotherNameAreUnknown) {
  EXPECT_THAT(find_rules("all-japn").errors, ElementsAre(Says("rules 'all-japn'", "'all-japan'")));
  EXPECT_THAT(find_rules("nowhere/rules.toml").errors, ElementsAre(SaysAt("nowhere/rules.toml", "no such")));
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
