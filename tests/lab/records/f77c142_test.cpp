// What commit f77c142 wrote, of which tests/data/f77c142/README.md says how: it is read for ever, and the same races
// give the same results.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "labmouse/lab/drive/drive_worlds.hpp"
#include "labmouse/lab/page/results.hpp"
#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/records/drive_json.hpp"
#include "labmouse/lab/records/drive_record_file.hpp"
#include "labmouse/lab/records/mms_record_file.hpp"
#include "labmouse/lab/records/record_file.hpp"
#include "labmouse/lab/reports/report_page.hpp"
#include "labmouse/lab/robots/drive_rules_file.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/standings/baseline.hpp"
#include "labmouse/lab/standings/race_json.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/worlds/worlds.hpp"
#include "tests/lab/mms/mms_fixture.hpp"
#include "tests/lab/reports/unpacking.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using Json = nlohmann::ordered_json;
using test::Says;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string folder = LABMOUSE_SOURCE_DIR "/tests/data/f77c142/";

std::string content(const std::string& name) {
  const FileContent file = read_file(folder + name);
  EXPECT_EQ(file.error, "") << name;
  return file.content;
}

/// A race of those mice in built-in mazes.
Race race_of(std::vector<Contestant> mice, const std::vector<std::string>& mazes, std::shared_ptr<const World> world) {
  return hold_race(std::move(mice), load_mazes(mazes).mazes, {std::move(world), 2, 1, 0});
}
Race race_of(std::vector<Contestant> mice, const std::vector<std::string>& mazes, std::string_view world,
             const WorldSettings& settings = {}) {
  return race_of(std::move(mice), mazes, find_world(world)->make(settings).world);
}

/// The robot `half` of those days.
std::shared_ptr<const World> world_of_half() {
  const Robot half = robot_of_the_past(find_robot("half").robot);
  return seconds_world(find_rules("thirtieth").rules, std::make_shared<DriveModel>(make_drive_model(half)));
}

std::vector<Race> races_in(const std::string& name) {
  const std::vector<std::string> two = {"parallel-8", "spiral-9"}, three = {"parallel-8", "spiral-9", "capstone-1"};
  std::vector<Race> races;
  if (name == "steps") {
    races.push_back(race_of(test::mice("flood,random,oracle"), three, "steps", {{"budget", "300"}}));
  } else if (name == "seconds") {
    races.push_back(race_of(test::mice("flood,ariadne"), two, world_of_half()));
  } else {
    races.push_back(race_of(test::mice("flood:stride=2"), two, "steps"));
    const std::vector<std::vector<std::string>> words = {
        {"ask:turnRight", "burst:4:moveForward", "hear:4", "ask:turnLeft", "burst:3:moveForward", "hear:3"},
        {"what?", "errors:oops", "ask:moveForward", "exit:3"}};
    std::vector<Contestant> programs;
    for (const auto& said : words)
      programs.push_back(test::mms_mouse(fmt::format("./mms_guest {}", fmt::join(said, " ")), said));
    races.push_back(race_of(std::move(programs), two, "mms"));
  }
  return races;
}

/// Expects everything of the past within what is now, except values of the clock and of the build, the words of notes,
/// which are for people, and intervals, which are found by another method now.
void expect_within(const Json& past, const Json& now, const std::string& place = "") {
  static const std::set<std::string> free = {"labmouse", "compiler",     "processor", "microseconds_per_decision",
                                             "seconds",  "mean_seconds", "interval"};
  if (past.is_object()) {
    for (const auto& [key, value] : past.items()) {
      const std::string path = place + "." + key;
      ASSERT_TRUE(now.is_object() && now.contains(key)) << path;
      if (!free.contains(key)) expect_within(value, now[key], path);
    }
  } else if (past.is_array()) {
    ASSERT_EQ(past.size(), now.size()) << place;
    for (std::size_t i = 0; i < past.size(); ++i) expect_within(past[i], now[i], fmt::format("{}[{}]", place, i));
  } else if (place.find(".notes[") == std::string::npos) {
    EXPECT_EQ(past, now) << place;
  }
}

/// Mice that walk otherwise by now: `random` goes over a map of the moves that it saw, `ariadne` weighs seconds
/// otherwise.
const std::set<std::string> changed = {"random", "ariadne"};

Json without_changed(Json results) {
  const auto leave_out = [](Json& mice) {
    mice.erase(
        std::remove_if(mice.begin(), mice.end(), [](const Json& mouse) { return changed.contains(mouse["name"]); }),
        mice.end());
  };
  results = with_groups(std::move(results));
  for (Json& group : results["groups"]) leave_out(group["mice"]);
  return results;
}

class OfThePast : public testing::TestWithParam<std::string> {
 protected:
  std::string results() const { return content(GetParam() + "/results.json"); }
};

INSTANTIATE_TEST_SUITE_P(Results, OfThePast, testing::Values("steps", "mms", "seconds"),
                         [](const auto& race) { return race.param; });

TEST_P(OfThePast, AreWhatTheSameRaceGivesNow) {
  expect_within(without_changed(Json::parse(results())),
                without_changed(Json::parse(json_of(races_in(GetParam()), {}))));
}

TEST_P(OfThePast, AreABaseline) {
  for (const Race& race : races_in(GetParam())) {
    const ReadBaselineResult read = read_baseline(results(), race.world());
    ASSERT_TRUE(read.baseline) << read.error;
    const std::string text = compare_with_baseline(race, *read.baseline);
    for (const Contestant& mouse : race.mice)
      if (!changed.contains(mouse.name)) {
        EXPECT_THAT(text, HasSubstr(mouse.name + ": +0.000 [+0.000, +0.000]"));
      }
    EXPECT_THAT(text, Not(HasSubstr("Warning")));
  }
}

TEST_P(OfThePast, MakeAReportWithTheRecordBesideThem) {
  const ReportPage report = make_report(folder + GetParam(), "<html><!-- labmouse:report --></html>");
  EXPECT_EQ(report.error, "");
  EXPECT_THAT(report.notes, Each(Says("left out", "record", folder + GetParam())));
  EXPECT_EQ(test::block_of(report.page, "labmouse-records")["records"].size(), 1U);
  EXPECT_EQ(test::block_of(report.page, "labmouse-report")["results"], with_groups(Json::parse(results())));
}

TEST(ThePast, IsReadByThePage) {
  for (const char* name : {"steps", "mms"}) {
    const auto past = nlohmann::json::parse(content(std::string(name) + "/results.json"));
    Json read;
    EXPECT_EQ(read_results(past, read), "") << name;
    EXPECT_EQ(read.at("groups").size(), with_groups(past).at("groups").size());
    EXPECT_EQ(read.at("groups").at(0).at("mice").size(), with_groups(past).at("groups").at(0).at("mice").size());
  }
}

TEST(ThePast, HasRecordsThatCanBePlayedAgain) {
  const ReadRecordResult steps = read_record(content("steps/random/parallel-8-1.jsonl"));
  ASSERT_TRUE(steps.file);
  EXPECT_EQ(replay(*steps.file, *steps.file->maze).disagreement, "");
  const ReadDriveRecordResult seconds = read_drive_record(content("seconds/flood/parallel-8-1.jsonl"));
  ASSERT_TRUE(seconds.file);
  EXPECT_EQ(replay(*seconds.file), "");
  const ReadMmsRecordResult mms = read_mms_record(
      content("mms/mms_._mms_guest_ask_turnRight_burst_4_moveForward_hear_4_ask_turnLeft_burst_3_moveForward_hear_3/"
              "parallel-8.jsonl"));
  ASSERT_TRUE(mms.file);
  EXPECT_EQ(replay(*mms.file, [](std::size_t, const MmsHost&) {}), "");
}

/// Robots of those days: their tables as they were then, which their records name, and a contest of flood.
TEST(ThePast, HasRobotsThatKeepTheirMeaning) {
  const std::map<std::string, std::uint64_t> hashes = {
      {"classic", 0xa579cb9e46f01a2c}, {"half", 0x10c39081f1137f0e}, {"mm2021", 0xf68d7d6dfc200793}};
  for (const auto& [name, hash] : hashes) {
    SCOPED_TRACE(name);
    const std::string text = content(fmt::format("robots/{}.toml", name));
    EXPECT_EQ(read_robot(text, name, RobotText::recorded).model.tables.hash, hash);
    EXPECT_EQ(read_robot(text, name).problems.size(), 0U);  // it can still be driven, by what is usual now
    if (name == "half") continue;
    const ReadDriveRecordResult read = read_drive_record(content(fmt::format("robots/{}.jsonl", name)));
    ASSERT_TRUE(read.file);
    EXPECT_EQ(read.file->tables_hash, hash);
    EXPECT_EQ(replay(*read.file), "");
  }
}

TEST(ThePast, HasRules) {
  DriveRules rules = find_rules(folder + "thirtieth.toml").rules;
  rules.name = "thirtieth";  // and not that of the file
  EXPECT_EQ(rules_json(rules), rules_json(find_rules("thirtieth").rules));
}

}  // namespace
}  // namespace labmouse
