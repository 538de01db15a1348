// Robots as files: what is read, and what is said of a file that is none.
#include "labmouse/lab/robots/robot_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "labmouse/hardware/beam.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using test::SaysAt;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::string_view by_limits =
    "cell = 180\n"
    "clearance = 45\n"
    "run_up = 50.5\n"
    "sight = 3\n"
    "[straight]\n"
    "speed = 3000\n"
    "acceleration = 10_000\n"
    "braking = 9000\n"
    "[diagonal]\n"
    "speed = 2500.0\n"
    "acceleration = 8000\n"
    "braking = 7000\n"
    "[curve]\n"
    "lateral_acceleration = 1e4\n"
    "yaw_acceleration = 300\n"
    "[search]\n"
    "speed = 500\n"
    "pivot_speed = 10\n"
    "pivot_acceleration = 100\n";

constexpr std::string_view by_times =
    "cell = 90\n"
    "[straight]\n"
    "speed = 1500\n"
    "acceleration = 4200\n"
    "[turns]\n"
    "speed = 420\n"
    "45 = 257\n"
    "90 = 375.5\n"
    "135 = 465\n"
    "180 = 563\n"
    "V90 = 388\n"
    "S90 = 280\n"
    "[search]\n"
    "cell = 300\n"
    "turn = 237\n"
    "back = 3000\n"
    "quarter = 1500\n"
    "half_cell = 300\n";

/// The text with its only `from` replaced.
std::string changed(std::string_view text, std::string_view from, std::string_view to) {
  std::string result(text);
  const auto at = result.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return result.replace(at, from.size(), to);
}

/// What is said of it.
std::vector<std::string> complaints(std::string_view text) {
  const RobotResult result = read_robot(text, "my.toml");
  EXPECT_NE(result.robot.has_value(), !result.problems.empty());
  std::vector<std::string> lines;
  for (const Problem& problem : result.problems) lines.push_back(describe("my.toml", problem));
  return lines;
}

TEST(RobotFile, ReadsLimits) {
  const RobotResult result = read_robot(by_limits, "mine");
  ASSERT_TRUE(result.robot) << testing::PrintToString(complaints(by_limits));
  const Robot& robot = *result.robot;
  EXPECT_EQ(robot.name, "mine");
  EXPECT_EQ(robot.cell, 180.0);
  EXPECT_EQ(robot.clearance, 45.0);
  EXPECT_EQ(robot.run_up, 50.5);
  EXPECT_EQ(robot.sight, 3);
  EXPECT_EQ(robot.speed, 3000.0);
  EXPECT_EQ(robot.acceleration, 10'000.0);
  EXPECT_EQ(robot.braking, 9000.0);
  EXPECT_EQ(robot.speed_diagonal, 2500.0);
  EXPECT_EQ(robot.acceleration_diagonal, 8000.0);
  EXPECT_EQ(robot.braking_diagonal, 7000.0);
  EXPECT_EQ(robot.lateral_acceleration, 10'000.0);
  EXPECT_EQ(robot.yaw_acceleration, 300.0);
  EXPECT_EQ(robot.search_speed, 500.0);
  EXPECT_EQ(robot.pivot_speed, 10.0);
  EXPECT_EQ(robot.pivot_acceleration, 100.0);
  EXPECT_FALSE(robot.fixed);
  EXPECT_EQ(robot.search, SearchDrive{});
  EXPECT_EQ(result.model.tables.hash, make_drive_model(robot).tables.hash);
  EXPECT_EQ(result.model.search.cell, 360'000);
}

TEST(RobotFile, ReadsDashesOfBothKindsOfRobots) {
  for (const std::string_view text : {by_limits, by_times}) {
    const RobotResult result =
        read_robot(changed(text, "[search]\n", "[search]\nknown_speed = 900\nknown_acceleration = 5000\n"), "mine");
    ASSERT_TRUE(result.robot);
    EXPECT_EQ(result.robot->known_speed, 900.0);
    EXPECT_EQ(result.robot->known_acceleration, 5000.0);
    EXPECT_LT(result.model.search.dash(9), 9 * result.model.search.cell);
  }
  EXPECT_THAT(complaints(changed(by_times, "[search]\n", "[search]\nknown_speed = 200\n")),
              ElementsAre(HasSubstr("search.known_speed")));
}

TEST(RobotFile, ReadsCommentsInAnyLettersAfterAMark) {
  const RobotResult result = read_robot("\xEF\xBB\xBF# mm/s², é, ミリ\r\n" + std::string(by_limits), "mine");
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(result.model.tables.hash, read_robot(by_limits, "mine").model.tables.hash);
}

TEST(RobotFile, ReadsTimes) {
  const RobotResult result = read_robot(by_times, "mine");
  ASSERT_TRUE(result.robot) << testing::PrintToString(complaints(by_times));
  const FixedTimes& fixed = *result.robot->fixed;
  EXPECT_EQ(fixed.speed, 420.0);
  EXPECT_EQ((std::vector{fixed.f45, fixed.f90, fixed.f135, fixed.f180, fixed.v90, fixed.s90}),
            (std::vector{257'000, 375'500, 465'000, 563'000, 388'000, 280'000}));
  EXPECT_EQ(result.robot->search, (SearchDrive{300'000, 237'000, 3'000'000, 1'500'000, 300'000}));
}

TEST(RobotFile, TakesWhatIsLeftOutFromWhatIsThere) {
  const Robot robot = *read_robot(by_times, "mine").robot;
  EXPECT_EQ(robot.braking, 4200.0);
  EXPECT_EQ(robot.speed_diagonal, 1500.0);
  EXPECT_EQ(robot.acceleration_diagonal, 4200.0);
  EXPECT_EQ(robot.braking_diagonal, 4200.0);
  EXPECT_EQ(robot.sight, 1);
  EXPECT_EQ(robot.run_up, 0.0);
}

TEST(RobotFile, SaysWhatIsMissingAndWhereItBelongs) {
  EXPECT_THAT(complaints(changed(by_limits, "clearance = 45\n", "")),
              ElementsAre(SaysAt("my.toml", "missing", "'clearance'", "0 to 500 mm")));
  EXPECT_THAT(complaints(changed(by_limits, "yaw_acceleration = 300\n", "")),
              ElementsAre(SaysAt("my.toml:13:1", "missing", "'curve.yaw_acceleration'", "1 to 100000 rad/s²")));
  EXPECT_THAT(complaints(changed(by_times, "V90 = 388\n", "")),
              ElementsAre(SaysAt("my.toml:5:1", "missing", "'turns.V90'", "1 to 10000 ms")));
  const RobotResult nothing = read_robot("", "my.toml");
  EXPECT_EQ(nothing.problems.size(), 9U);
}

TEST(RobotFile, SaysWhatItDoesNotKnow) {
  EXPECT_THAT(complaints(changed(by_limits, "braking = 9000", "breaking = 9000")),
              ElementsAre(SaysAt("my.toml:8:1", "unknown", "'straight.breaking'", "'straight.braking'")));
  EXPECT_THAT(complaints(changed(by_limits, "sight = 3", "colour = \"red\"")),
              ElementsAre(SaysAt("my.toml:4:1", "unknown", "'colour'")));
  EXPECT_THAT(complaints(changed(by_limits, "[curve]", "[curves]")),
              Contains(SaysAt("my.toml:13:2", "unknown", "'curves'", "'curve'")));
  EXPECT_THAT(complaints(changed(by_limits, "[diagonal]", "[diagonals]")),
              ElementsAre(SaysAt("my.toml:9:1", "'diagonals'", "true or false", "[diagonal]")));
  EXPECT_THAT(complaints(changed(by_limits, "sight = 3", "\"\\u001b[2J\" = 3")), Each(Not(HasSubstr("\x1b"))));
}

TEST(RobotFile, SaysWhatANumberMayBe) {
  EXPECT_THAT(complaints(changed(by_limits, "speed = 3000", "speed = 3")),
              ElementsAre(SaysAt("my.toml:6:9", "'straight.speed'", "3", "50 to 20000 mm/s", "3000")));
  EXPECT_THAT(
      complaints(changed(by_limits, "pivot_speed = 10", "pivot_speed = 573")),
      ElementsAre(SaysAt("my.toml:18:15", "'search.pivot_speed'", "0.1 to 100 rad/s", "degrees/s", "write 10")));
  EXPECT_THAT(complaints(changed(by_limits, "speed = 3000", "speed = \"fast\"")),
              ElementsAre(SaysAt("my.toml:6:9", "'straight.speed'", "number", "mm/s")));
  EXPECT_THAT(complaints(changed(by_limits, "sight = 3", "sight = 2.5")),
              ElementsAre(SaysAt("my.toml:4:9", "'sight'", "2.5", "whole number", "1 to 32 cells")));
  for (const std::string value : {"nan", "9007199254740993", "-9223372036854775808"})
    EXPECT_THAT(complaints(changed(by_limits, "clearance = 45", "clearance = " + value)),
                ElementsAre(SaysAt("my.toml:2:13", "'clearance'", value, "0 to 500 mm")));
  EXPECT_THAT(complaints(changed(by_limits, "run_up = 50.5", "run_up = -1")),
              ElementsAre(SaysAt("my.toml:3:10", "'run_up'", "-1", "0 to 500 mm")));
  EXPECT_THAT(complaints("straight = 3\n" +
                         changed(by_limits, "[straight]\nspeed = 3000\nacceleration = 10_000\nbraking = 9000\n", "")),
              ElementsAre(SaysAt("my.toml:1:1", "'straight'", "table", "[straight]"),
                          SaysAt("my.toml:1:12", "missing", "'straight.speed'", "50 to 20000 mm/s"),
                          SaysAt("my.toml:1:12", "missing", "'straight.acceleration'", "100 to 200000 mm/s²")));
}

TEST(RobotFile, TakesEachKeyOnlyWhereItCounts) {
  EXPECT_THAT(complaints(changed(by_times, "cell = 90\n", "cell = 90\nclearance = 18\n")),
              ElementsAre(SaysAt("my.toml:2:13", "'clearance'", "[turns]")));
  EXPECT_THAT(complaints(changed(by_times, "cell = 300\n", "cell = 300\nspeed = 300\n")),
              ElementsAre(SaysAt("my.toml:15:9", "'search.speed'", "'search.cell'")));
  EXPECT_THAT(complaints(changed(by_limits, "speed = 500\n", "speed = 500\nback = 3000\n")),
              ElementsAre(SaysAt("my.toml:18:8", "'search.back'", "'search.cell'")));
}

TEST(RobotFile, PassesOnWhatIsNoToml) {
  EXPECT_THAT(complaints("cell = 180\nclearance 45\n"), Contains(SaysAt("my.toml:2:11")));
  EXPECT_THAT(complaints("cell = 180\ncell = 90\n"), Contains(SaysAt("my.toml:2:8")));
  EXPECT_THAT(complaints("\xff\xfe"), Not(IsEmpty()));
  EXPECT_THAT(complaints("[    \n"), Contains(SaysAt("my.toml:1:6")));
  EXPECT_THAT(complaints(changed(by_limits, "sight = 3", "sight = ²")), Contains(SaysAt("my.toml:4:9")));
  EXPECT_THAT(complaints(std::string(70'000, '#')), ElementsAre(SaysAt("my.toml", "70000 bytes", "65536")));
}

TEST(RobotFile, ListsAtMostTenProblems) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += fmt::format("strange{} = 1\n", i);
  EXPECT_EQ(read_robot(text, "my.toml").problems.size(), most_problems);
}

TEST(RobotFile, PassesOnWhatItsModelRefuses) {
  EXPECT_THAT(complaints(changed(by_limits, "clearance = 45", "clearance = 70")),
              ElementsAre(SaysAt("my.toml", "clearance of 70 mm", "180 mm", "63.6 mm")));
  EXPECT_THAT(complaints(changed(by_limits, "speed = 500", "speed = 900")),
              ElementsAre(SaysAt("my.toml", "S90", "850 mm/s", "search.turn_speed")));
}

TEST(RobotFile, ReadsEveryNumberThatItsKeysAllow) {
  // Whatever the numbers, there is a model or a sentence.
  for (const std::string_view text : {by_limits, by_times})
    for (const RobotKey& key : robot_keys())
      for (const double value : {key.low, key.high}) {
        const std::string name(key.name.substr(key.name.find('.') + 1));
        const auto section = key.name.find('.') == std::string_view::npos
                                 ? std::size_t{0}
                                 : text.find(fmt::format("[{}]", key.name.substr(0, key.name.find('.'))));
        const auto at = text.find("\n" + name + " = ", section);
        if (section == std::string_view::npos || at == std::string_view::npos) continue;
        std::string other(text);
        other.replace(at + 1, other.find('\n', at + 1) - at - 1, fmt::format("{} = {}", name, value));
        const RobotResult result = read_robot(other, "my.toml");
        EXPECT_NE(result.robot.has_value(), !result.problems.empty()) << other;
        EXPECT_EQ(result.robot.has_value(), result.model.tables.hash != 0U) << other;
      }
}

TEST(RobotFile, MayLeaveOutTurns) {
  const auto robot_of = [](const std::string& text) { return *read_robot(text, "mine").robot; };
  const Robot square = robot_of("diagonals = false\n" + changed(by_limits,
                                                                "[diagonal]\nspeed = 2500.0\n"
                                                                "acceleration = 8000\nbraking = 7000\n",
                                                                ""));
  EXPECT_FALSE(square.diagonals);
  EXPECT_TRUE(square.drives(Turn::f180));
  EXPECT_FALSE(square.drives(Turn::out45));
  const Robot fewer =
      robot_of(changed(by_limits, "[search]", "[layout]\n180 = false\nV90 = false\n45 = 900\n[search]"));
  EXPECT_FALSE(fewer.drives(Turn::f180));
  EXPECT_FALSE(fewer.drives(Turn::v90));
  EXPECT_EQ(fewer.layout(Turn::out45).given, 900.0);
  const Robot fixed = robot_of(changed(by_times, "180 = 563", "180 = false"));
  EXPECT_FALSE(fixed.drives(Turn::f180));
  EXPECT_THAT(complaints("diagonals = false\n" + std::string(by_limits)),
              Contains(SaysAt("my.toml:11:9", "'diagonal.speed'", "without diagonals")));
  EXPECT_THAT(complaints(changed(by_times, "S90 = 280", "S90 = false")),
              ElementsAre(SaysAt("my.toml:12:7", "'turns.S90'")));
  EXPECT_THAT(complaints(changed(by_times, "180 = 563", "180 = true")),
              ElementsAre(SaysAt("my.toml:10:7", "'turns.180'")));
}

TEST(RobotFile, BrakesOnDiagonalsAsItSpeedsUpThere) {
  const auto braking = [](const std::string& text) { return read_robot(text, "mine").robot->braking_diagonal; };
  EXPECT_EQ(braking(changed(by_limits, "acceleration = 8000\nbraking = 7000\n", "acceleration = 8000\n")), 8000.0);
  EXPECT_EQ(braking(changed(by_limits, "acceleration = 8000\nbraking = 7000\n", "")), 9000.0);
}

TEST(RobotFiles, BringsFiveRobots) {
  std::vector<std::string_view> names;
  for (const BuiltinRobot& robot : builtin_robots()) names.push_back(robot.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"beginner", "classic", "half", "kerise", "mm2021"}));
  for (const std::string_view name : names) {
    const FoundRobot found = find_robot(std::string(name));
    EXPECT_TRUE(found.errors.empty()) << name;
    EXPECT_EQ(found.robot.name, name);
  }
}

TEST(RobotFiles, SaysWhichRobotThereIsNot) {
  EXPECT_THAT(find_robot("clasic").errors, ElementsAre(Says("robot 'clasic'", "'classic'")));
  EXPECT_THAT(find_robot("hovercraft").errors,
              ElementsAre(Says("robot 'hovercraft'", "beginner, classic, half, kerise, mm2021", ".toml")));
  EXPECT_THAT(find_robot("nowhere.toml").errors, ElementsAre(SaysAt("nowhere.toml", "no such")));
}

/// docs/explanation/physical-model.md says which logs and which firmware these are from.
TEST(RobotFiles, HaveMeasuredMotors) {
  const Motors kerise = find_robot("kerise").robot.hardware->motors;
  EXPECT_DOUBLE_EQ(kerise.drive.gain, 4216.0);
  EXPECT_DOUBLE_EQ(kerise.drive.time, 0.152);
  EXPECT_DOUBLE_EQ(kerise.drive.dead_zone, 0.0);
  EXPECT_DOUBLE_EQ(kerise.turning, 0.0018);
  // Wheels that do not slip turn the beginner's mouse by what they roll: its author measured driving and turning apart.
  const Hardware beginner = *find_robot("beginner").robot.hardware;
  const double rolled = beginner.motors.drive.gain / (2.0 * beginner.chassis.half_track);
  EXPECT_NEAR(beginner.motors.turn.gain, rolled, 0.1 * rolled);
}

TEST(RobotFiles, ReadsAFile) {
  const std::string path = LABMOUSE_SOURCE_DIR "/robots/half.toml";
  const FoundRobot found = find_robot(path);
  EXPECT_TRUE(found.errors.empty());
  EXPECT_EQ(found.robot.name, path);
  EXPECT_EQ(found.model.tables.hash, find_robot("half").model.tables.hash);
}

TEST(RobotFile, SideSensorsOfAnyAngleLookAsideAndFrontSensorsAhead) {
  const RobotKey &side = *find_robot_key("sensors.side_angle"), &front = *find_robot_key("sensors.front_angle");
  for (const double angle : {side.low, side.high}) EXPECT_EQ(side_of(Beam{0.0, 0.0, angle}), BeamSide::left) << angle;
  for (const double angle : {front.low, front.high})
    EXPECT_EQ(side_of(Beam{0.0, 0.0, angle}), BeamSide::ahead) << angle;
  EXPECT_LE(side.low, 0.785) << "45 degrees, cut to three digits";
}

}  // namespace
}  // namespace labmouse
