// A contest in seconds as the page plays it.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "labmouse/lab/mazes/builtin_mazes.hpp"
#include "tests/lab/page/page_fixture.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::answer;
using test::data_of;
using test::error_of;
using test::failure;
using test::json;
using test::Says;
using test::SaysAt;
using ::testing::HasSubstr;

NamedMaze builtin(std::string_view name) {
  for (const BuiltinMaze& maze : builtin_mazes())
    if (maze.name == name) return {std::string(name), *read_maze(maze.text).maze};
  throw std::runtime_error("no such maze");
}

json driving(const NamedMaze& maze, const std::string& mouse = "certify", const std::string& robot = "mm2021",
             const std::string& rules = "all-japan") {
  return {{"mouse", mouse},     {"maze", data_of(maze)}, {"seed", 1},
          {"world", "seconds"}, {"robot", robot},        {"rules", rules}};
}

json play_of(const NamedMaze& maze, const std::string& mouse = "certify", const std::string& robot = "mm2021") {
  return answer("contest", driving(maze, mouse, robot))["play"];
}

/// A place on the path of a play.
struct Spot {
  double t, x, y, heading, v, a;
};

Spot spot_of(const json& path, std::size_t i) {
  return {path["t"][i], path["x"][i], path["y"][i], path["heading"][i], path["v"][i], path["a"][i]};
}

/// One cell ahead of the start, and one cell ahead again: each number follows from the published times of the robot.
TEST(PageDrive, HasEachMoveAndEachSegment) {
  const json play = play_of(test::hook(), "flood");
  EXPECT_EQ(play["world"], "seconds");
  EXPECT_EQ(play["outcome"], "finished");
  const json& drive = play["drive"];
  ASSERT_EQ(drive["runs"].size(), 3);
  EXPECT_EQ(drive["runs"][0]["kind"], "search");
  EXPECT_EQ(drive["runs"][1]["kind"], "home");
  EXPECT_EQ(drive["runs"][2]["kind"], "speed");
  EXPECT_EQ(play["action"][0], "ahead 1");
  EXPECT_EQ(play["action"].back(), "ahead 1");
  EXPECT_EQ(play["clock"].size(), play["action"].size() + 1);
  // From the middle of the start cell to the edge of the goal.
  EXPECT_EQ((json{play["x"][0], play["y"][0]}), (json{1, 1}));
  EXPECT_EQ((json{play["x"][1], play["y"][1]}), (json{1, 2}));
  EXPECT_EQ(play["entered"][0], json{2});
  EXPECT_EQ(play["goal_frame"], 1);
  EXPECT_EQ(play["reset_frame"], drive["runs"][2]["frame"]);
  EXPECT_EQ(play["clock"].back().get<double>() * 1e6, drive["runs"][2]["end"].get<double>());
  EXPECT_EQ(play["score"].get<double>() * 1e6, drive["runs"][2]["score"]["value"].get<double>());
  EXPECT_EQ(play["scores"].back(), play["score"]);
  EXPECT_TRUE(play["scores"][0].is_null());
  // From the start it sees that the goal is open, and in the loop it does not.
  EXPECT_EQ(drive["runs"][0]["known"], drive["runs"][2]["known"]);
  EXPECT_EQ(drive["runs"][2]["known"], drive["runs"][2]["possible"]);
  EXPECT_EQ(play_of(test::loop(), "flood")["drive"]["runs"][0]["known"], nullptr);
}

/// Of every run the path begins and ends with the run, and its points agree: the way between two of them is what the
/// speeds at both make of the time between, and each frame of the play lies on it.
TEST(PageDrive, DrawsAPathThatIsDrivenAtItsSpeeds) {
  for (const char* robot : {"mm2021", "classic", "half"})
    for (const char* mouse : {"flood", "certify", "ariadne"}) {
      SCOPED_TRACE(std::string(robot) + " " + mouse);
      const json play = play_of(builtin("capstone-1"), mouse, robot);
      const json &path = play["drive"]["path"], &runs = play["drive"]["runs"];
      const double cell = play["drive"]["robot"]["cell"];
      for (const json& run : runs) {
        const std::size_t from = run["from"], to = run["to"];
        ASSERT_LT(from, to);
        EXPECT_EQ(path["t"][from], run["begin"]);
        EXPECT_EQ(path["t"][to - 1], run["end"]);
        for (std::size_t i = from + 1; i < to; ++i) {
          const Spot a = spot_of(path, i - 1), b = spot_of(path, i);
          const double seconds = (b.t - a.t) / 1e6, driven = (a.v + b.v) / 2 * seconds;
          ASSERT_GE(seconds, 0.0);
          EXPECT_NEAR(b.v - a.v, a.a * seconds, seconds > 0 ? 2.0 : 1e9) << i;
          EXPECT_NEAR(std::hypot(b.x - a.x, b.y - a.y) * cell, driven, std::max(1.0, 0.03 * driven)) << i;
          EXPECT_LE(std::abs(b.heading - a.heading), 4.001);
        }
      }
      EXPECT_EQ(runs.back()["to"], path["t"].size());
    }
}

/// Where the mouse looks is where it goes, unless it turns on the spot.
TEST(PageDrive, LooksWhereItGoes) {
  const json play = play_of(builtin("capstone-1"), "certify", "classic");
  const json& path = play["drive"]["path"];
  for (const json& run : play["drive"]["runs"])
    for (std::size_t i = run["from"].get<std::size_t>() + 1; i < run["to"]; ++i) {
      const Spot a = spot_of(path, i - 1), b = spot_of(path, i);
      const double dx = b.x - a.x, dy = b.y - a.y;
      if (std::hypot(dx, dy) < 0.01) continue;
      const double direction = std::atan2(dx, dy) * 4 / std::numbers::pi;
      EXPECT_NEAR(std::remainder(direction - (a.heading + b.heading) / 2, 8.0), 0.0, 0.15) << i;
    }
}

TEST(PageDrive, KeepsFramesOnThePath) {
  const json play = play_of(builtin("capstone-1"), "certify", "half");
  const json& path = play["drive"]["path"];
  const double run_up = 0.7;  // of a cell, behind the start
  for (const json& run : play["drive"]["runs"]) {
    const std::size_t first = run["from"], last = run["to"].get<std::size_t>() - 1, frame = run["frame"];
    EXPECT_NEAR(path["x"][first].get<double>() * 2, play["x"][frame].get<double>(), run_up);
    EXPECT_NEAR(path["y"][first].get<double>() * 2, play["y"][frame].get<double>(), run_up);
    EXPECT_EQ(play["run"][frame], run["kind"] == "search" ? 0 : run["kind"] == "home" ? 1 : 2);
    EXPECT_EQ(run["begin"].get<double>() / 1e6, play["clock"][frame].get<double>());
    EXPECT_LE(path["t"][last].get<double>() / 1e6, play["clock"].back().get<double>());
  }
}

/// Nothing before the first goal; a search that reached a goal counts as well as a run.
TEST(PageDrive, ScoresEachRunOnceItReachesTheGoal) {
  const json play = play_of(builtin("capstone-1"), "certify", "classic");
  const json& runs = play["drive"]["runs"];
  const std::size_t goal = play["goal_frame"], last = play["scores"].size() - 1;
  EXPECT_TRUE(play["scores"][goal - 1].is_null());
  EXPECT_EQ(play["scores"][goal].get<double>() * 1e6, runs[0]["score"]["value"].get<double>());
  EXPECT_EQ(play["scores"][last - 1], play["scores"][goal]);
  EXPECT_LT(play["scores"][last], play["scores"][goal]);
  EXPECT_EQ(play["scores"][last].get<double>() * 1e6, runs.back()["score"]["value"].get<double>());
  EXPECT_GE(play["score"], play["bound"]);
}

TEST(PageDrive, KnowsWallsFromTheFrameInWhichTheyAreSeen) {
  const json play = play_of(test::hook(), "flood");
  // The border from the beginning, the walls of the start cell too; those of the goal once it is entered.
  EXPECT_EQ(play["known"][0], 0);
  EXPECT_EQ(play["known"][4], 0);
  EXPECT_EQ(play["known"][6], 1);
  EXPECT_EQ(play["known"][1], -1);
}

TEST(PageDrive, SaysWhatCannotBeDriven) {
  EXPECT_THAT(error_of("contest", driving(test::hook(), "random")), Says("'random'", "seconds", "flood, "));
  EXPECT_THAT(error_of("contest", driving(test::hook(), "flood,certify")), Says("'flood,certify'", "several"));
  EXPECT_THAT(error_of("contest", driving(test::hook(), "flood", "tank")), HasSubstr("'tank'"));
  EXPECT_THAT(error_of("contest", driving(test::hook(), "flood", "half", "chess")), HasSubstr("'chess'"));
  EXPECT_THAT(error_of("contest", {{"mouse", "flood"}}), Says("'maze'", "missing"));
  const NamedMaze large = {"large", Maze(MazeDraft({33, 4}, MazeDraft::Inside::open))};
  EXPECT_THAT(error_of("contest", driving(large)), Says("33x4", "32x32"));
}

/// Where no goal can be reached there is a search and no more.
TEST(PageDrive, PlaysWhatEndsWithoutARun) {
  const json play = play_of(test::without_route(), "flood");
  EXPECT_EQ(play["finished"], false);
  EXPECT_EQ(play["score"], nullptr);
  EXPECT_EQ(play["bound"], nullptr);
  EXPECT_EQ(play["goal_frame"], nullptr);
  EXPECT_TRUE(play["drive"]["best"]["t"].empty());
}

TEST(PageDrive, OpensARecordAsItWasDriven) {
  const json driven = answer("contest", driving(test::hook()));
  const std::string record = driven["record"];
  const json opened = answer("open", {{"name", "hook.jsonl"}}, record);
  EXPECT_EQ(opened["kind"], "record");
  EXPECT_EQ(opened["play"], driven["play"]);
  EXPECT_THAT(answer("picture", json::object(), record)["svg"].get<std::string>(), HasSubstr("<title>certify in "));
  const std::string cut = record.substr(0, record.rfind("{\"outcome\""));
  EXPECT_EQ(answer("open", {{"name", "cut.jsonl"}}, cut)["play"]["ended"], false);
}

TEST(PageDrive, OpensNoRecordThatCannotHaveHappened) {
  const std::string record = answer("contest", driving(test::hook(), "flood"))["record"];
  std::string changed = record;
  changed.replace(changed.find("\"until\":300000"), 14, "\"until\":300001");
  for (const char* call : {"open", "picture"})
    EXPECT_THAT(failure(call, {{"name", "changed.jsonl"}}, changed)["problems"][0]["reason"].get<std::string>(),
                SaysAt("run 1 (search): move 1", "0.300001 s"))
        << call;
  const json cut = failure("open", {{"name", "cut.jsonl"}}, record.substr(0, 100));
  EXPECT_THAT(cut["error"].get<std::string>(), Says("cut.jsonl", "record"));
  EXPECT_THAT(cut["problems"][0]["reason"].get<std::string>(), HasSubstr("JSON"));
}

}  // namespace
}  // namespace labmouse
