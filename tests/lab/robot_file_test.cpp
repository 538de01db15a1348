// Robots as files: what is read, and what is said of a file that is none.
#include "labmouse/lab/robots/robot_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_keys.hpp"

namespace labmouse {
namespace {

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

/// What is said of it, a line a problem.
std::string complaint(std::string_view text) {
  const RobotResult result = read_robot(text, "my.toml");
  EXPECT_NE(result.robot.has_value(), !result.problems.empty());
  std::string lines;
  for (const Problem& problem : result.problems) lines += describe("my.toml", problem) + "\n";
  return lines;
}

TEST(RobotFile, ReadsLimits) {
  const RobotResult result = read_robot(by_limits, "mine");
  ASSERT_TRUE(result.robot) << complaint(by_limits);
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

TEST(RobotFile, ReadsCommentsInAnyLettersAfterAMark) {
  const RobotResult result = read_robot("\xEF\xBB\xBF# mm/s², é, ミリ\r\n" + std::string(by_limits), "mine");
  ASSERT_TRUE(result.robot);
  EXPECT_EQ(result.model.tables.hash, read_robot(by_limits, "mine").model.tables.hash);
}

TEST(RobotFile, ReadsTimes) {
  const RobotResult result = read_robot(by_times, "mine");
  ASSERT_TRUE(result.robot) << complaint(by_times);
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
  EXPECT_EQ(complaint(changed(by_limits, "clearance = 45\n", "")),
            "my.toml: error: missing key 'clearance': 0 to 500 mm\n");
  EXPECT_EQ(complaint(changed(by_limits, "yaw_acceleration = 300\n", "")),
            "my.toml:13:1: error: missing key 'curve.yaw_acceleration': 1 to 100000 rad/s²\n");
  EXPECT_EQ(complaint(changed(by_times, "V90 = 388\n", "")),
            "my.toml:5:1: error: missing key 'turns.V90': 1 to 10000 ms\n");
  const RobotResult nothing = read_robot("", "my.toml");
  EXPECT_EQ(nothing.problems.size(), 9U);
}

TEST(RobotFile, SaysWhatItDoesNotKnow) {
  EXPECT_EQ(complaint(changed(by_limits, "braking = 9000", "breaking = 9000")),
            "my.toml:8:1: error: unknown key 'straight.breaking'; did you mean 'straight.braking'?\n");
  EXPECT_EQ(complaint(changed(by_limits, "sight = 3", "colour = \"red\"")),
            "my.toml:4:1: error: unknown key 'colour'\n");
  EXPECT_EQ(complaint(changed(by_limits, "[diagonal]", "[diagonals]")),
            "my.toml:9:2: error: unknown key 'diagonals'; did you mean 'diagonal'?\n");
  EXPECT_EQ(complaint(changed(by_limits, "sight = 3", "\"\\u001b[2J\" = 3")).find('\x1b'), std::string::npos);
}

TEST(RobotFile, SaysWhatANumberMayBe) {
  EXPECT_EQ(complaint(changed(by_limits, "speed = 3000", "speed = 3")),
            "my.toml:6:9: error: 'straight.speed' is 3; it must be 100 to 20000 mm/s; if that is in m/s, write 3000\n");
  EXPECT_EQ(complaint(changed(by_limits, "speed = 3000", "speed = \"fast\"")),
            "my.toml:6:9: error: 'straight.speed' must be a number of mm/s\n");
  EXPECT_EQ(complaint(changed(by_limits, "sight = 3", "sight = 2.5")),
            "my.toml:4:9: error: 'sight' is 2.5; it must be a whole number, 1 to 32 cells\n");
  EXPECT_EQ(complaint(changed(by_limits, "clearance = 45", "clearance = nan")),
            "my.toml:2:13: error: 'clearance' is nan; it must be 0 to 500 mm\n");
  EXPECT_EQ(complaint(changed(by_limits, "clearance = 45", "clearance = 9007199254740993")),
            "my.toml:2:13: error: 'clearance' is 9007199254740993; it must be 0 to 500 mm\n");
  EXPECT_EQ(complaint(changed(by_limits, "clearance = 45", "clearance = -9223372036854775808")),
            "my.toml:2:13: error: 'clearance' is -9223372036854775808; it must be 0 to 500 mm\n");
  EXPECT_EQ(complaint(changed(by_limits, "run_up = 50.5", "run_up = -1")),
            "my.toml:3:10: error: 'run_up' is -1; it must be 0 to 500 mm\n");
  EXPECT_EQ(complaint("straight = 3\n" +
                      changed(by_limits, "[straight]\nspeed = 3000\nacceleration = 10_000\nbraking = 9000\n", "")),
            "my.toml:1:1: error: 'straight' must be a table: [straight]\n"
            "my.toml:1:12: error: missing key 'straight.speed': 100 to 20000 mm/s\n"
            "my.toml:1:12: error: missing key 'straight.acceleration': 100 to 200000 mm/s²\n");
}

TEST(RobotFile, TakesEachKeyOnlyWhereItCounts) {
  EXPECT_EQ(complaint(changed(by_times, "cell = 90\n", "cell = 90\nclearance = 18\n")),
            "my.toml:2:13: error: 'clearance' has no meaning beside [turns], which has the times of all turns\n");
  EXPECT_EQ(complaint(changed(by_times, "cell = 300\n", "cell = 300\nspeed = 300\n")),
            "my.toml:15:9: error: 'search.speed' has no meaning beside 'search.cell', which begins a table of times\n");
  EXPECT_EQ(complaint(changed(by_limits, "speed = 500\n", "speed = 500\nback = 3000\n")),
            "my.toml:18:8: error: 'search.back' belongs to a table of times, which needs 'search.cell'\n");
}

TEST(RobotFile, PassesOnWhatIsNoToml) {
  EXPECT_EQ(complaint("cell = 180\nclearance 45\n").substr(0, 16), "my.toml:2:11: er");
  EXPECT_EQ(complaint("cell = 180\ncell = 90\n").substr(0, 15), "my.toml:2:8: er");
  EXPECT_NE(complaint("\xff\xfe"), "");
  EXPECT_EQ(complaint("[    \n").substr(0, 15), "my.toml:1:6: er");
  EXPECT_EQ(complaint(changed(by_limits, "sight = 3", "sight = ²")).substr(0, 15), "my.toml:4:9: er");
  EXPECT_EQ(complaint(std::string(70'000, '#')), "my.toml: error: has 70000 bytes; more than 65536 is too large\n");
}

TEST(RobotFile, ListsAtMostTenProblems) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += fmt::format("strange{} = 1\n", i);
  EXPECT_EQ(read_robot(text, "my.toml").problems.size(), most_problems);
}

TEST(RobotFile, PassesOnWhatItsModelRefuses) {
  EXPECT_EQ(complaint(changed(by_limits, "clearance = 45", "clearance = 70")),
            "my.toml: error: a clearance of 70 mm is more than diagonals leave in cells of 180 mm: 63.6 mm from their "
            "middle to a post\n");
  EXPECT_EQ(
      complaint(changed(by_limits, "yaw_acceleration = 300", "yaw_acceleration = 30")),
      "my.toml: error: its turn S90 fits into cells of 180 mm only up to 330 mm/s: a cell of 180 mm must not take "
      "more than 500 ms, the longest that times here are made for, so at least 360 mm/s are needed; a larger lateral "
      "or yaw acceleration makes it faster\n");
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

TEST(RobotFiles, BringsThreeRobots) {
  std::vector<std::string_view> names;
  for (const BuiltinRobot& robot : builtin_robots()) names.push_back(robot.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"classic", "half", "mm2021"}));
  for (const std::string_view name : names) {
    const FoundRobot found = find_robot(std::string(name));
    EXPECT_TRUE(found.errors.empty()) << name;
    EXPECT_EQ(found.robot.name, name);
  }
}

TEST(RobotFiles, SaysWhichRobotThereIsNot) {
  EXPECT_EQ(find_robot("clasic").errors,
            (std::vector<std::string>{"error: unknown robot 'clasic'; did you mean 'classic'?"}));
  EXPECT_EQ(
      find_robot("hovercraft").errors,
      (std::vector<std::string>{"error: unknown robot 'hovercraft'; there are classic, half, mm2021, and files with "
                                "a slash or .toml in their name"}));
  ASSERT_EQ(find_robot("nowhere.toml").errors.size(), 1U);
  EXPECT_EQ(find_robot("nowhere.toml").errors[0].substr(0, 21), "nowhere.toml: error: ");
}

TEST(RobotFiles, ReadsAFile) {
  const std::string path = LABMOUSE_SOURCE_DIR "/robots/half.toml";
  const FoundRobot found = find_robot(path);
  EXPECT_TRUE(found.errors.empty());
  EXPECT_EQ(found.robot.name, path);
  EXPECT_EQ(found.model.tables.hash, find_robot("half").model.tables.hash);
}

}  // namespace
}  // namespace labmouse
