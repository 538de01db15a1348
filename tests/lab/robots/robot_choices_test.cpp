// What a robot file may choose beyond its limits: speeds, where runs end, grip, which turns are driven; and that
// records keep each choice.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_file.hpp"
#include "labmouse/lab/robots/robot_json.hpp"
#include "tests/says.hpp"

namespace labmouse {
namespace {

using test::Says;
using ::testing::ElementsAre;

/// A robot that is read with some lines more at its top, in [curve] and in [layout].
struct Lines {
  std::string top = {}, curve = {}, layout = {};
};

std::string text_of(const Lines& lines) {
  const bool diagonals = lines.top.find("diagonals = false") == std::string::npos;
  return lines.top +
         "\ncell = 180\nclearance = 45\nrun_up = 40\n"
         "[straight]\nspeed = 3000\nacceleration = 8000\nbraking = 9000\n" +
         (diagonals ? "[diagonal]\nspeed = 2500\nacceleration = 7000\nbraking = 6000\n" : "") +
         "[curve]\nlateral_acceleration = 10000\nyaw_acceleration = 300\n" + lines.curve + "\n[layout]\n" +
         lines.layout + "\n[search]\nspeed = 500\npivot_speed = 10\npivot_acceleration = 100\n";
}

RobotResult read(const Lines& lines) { return read_robot(text_of(lines), "mine"); }

/// A model that must be there.
DriveModel model_of(const Lines& lines) {
  RobotResult result = read(lines);
  EXPECT_TRUE(result.robot) << (result.problems.empty() ? "" : result.problems.front().reason);
  return std::move(result.model);
}

std::vector<std::string> reasons(const RobotResult& result) {
  std::vector<std::string> reasons;
  for (const Problem& problem : result.problems) reasons.push_back(problem.reason);
  return reasons;
}

std::set<double> speeds_of(const DriveTables& tables, Turn turn) {
  std::set<double> speeds;
  for (const DrivenTurn& driven : tables.turns)
    if (driven.turn == turn) speeds.insert(driven.speed);
  return speeds;
}

bool has_turn(const DriveTables& tables, Turn turn) { return !speeds_of(tables, turn).empty(); }

TEST(RobotChoices, AreThoseOfMostRobotsWhereNothingIsSaid) {
  const DriveModel model = model_of({});
  EXPECT_EQ(model.robot.speeds, 6);
  EXPECT_EQ(model.robot.stop, Stop::goal);
  EXPECT_EQ(model.robot.grip, 0.0);
  EXPECT_EQ(model.robot.yaw_speed, 0.0);
  EXPECT_EQ(model.robot.yaw_jerk, 0.0);
  for (const Turn turn : all_turns) EXPECT_TRUE(has_turn(model.tables, turn)) << name_of(turn);
  for (const Lines& same : {Lines{"", "speeds = 6", ""}, Lines{"stop = \"goal\"", "", ""}, Lines{"diagonals = true"}})
    EXPECT_EQ(model_of(same).tables.hash, model.tables.hash);
}

TEST(RobotChoices, AreOneToEightSpeedsOfATurn) {
  for (int speeds = 1; speeds <= most_speeds; ++speeds) {
    const DriveModel model = model_of({"", fmt::format("speeds = {}", speeds), ""});
    EXPECT_EQ(model.robot.speeds, speeds);
    std::size_t most = 0;
    for (const Turn turn : all_turns) most = std::max(most, speeds_of(model.tables, turn).size());
    EXPECT_EQ(most, static_cast<std::size_t>(speeds));
  }
  for (const std::string odd : {"0", "-1", "9", "2.5", "6.0", "nan"})
    EXPECT_THAT(reasons(read({"", "speeds = " + odd, ""})), ElementsAre(Says("'curve.speeds'", "whole", "1 to 8")))
        << odd;
  EXPECT_THAT(reasons(read({"", "speeds = \"many\"", ""})), ElementsAre(Says("'curve.speeds'", "number")));
}

TEST(RobotChoices, AreWhereARunMayEnd) {
  const DriveModel goal = model_of({"stop = \"goal\""}), beyond = model_of({"stop = \"beyond\""});
  EXPECT_EQ(goal.robot.stop, Stop::goal);
  EXPECT_EQ(beyond.robot.stop, Stop::beyond);
  EXPECT_GT(goal.tables.rooms(), 1);
  EXPECT_EQ(beyond.tables.rooms(), 1);
  EXPECT_GT(goal.tables.whole_way(8, 0), beyond.tables.whole_way(8, 0));
  EXPECT_EQ(goal.tables.whole_way(8, max_drive_side), beyond.tables.whole_way(8, 0));
  for (const std::string odd : {"\"Goal\"", "\"\"", "\"start\"", "1", "true"})
    EXPECT_THAT(reasons(read({"stop = " + odd})), ElementsAre(Says("'stop'", "\"goal\"", "\"beyond\""))) << odd;
}

TEST(RobotChoices, AreGripOfAtLeastEveryAcceleration) {
  EXPECT_EQ(model_of({"", "grip = 10000", ""}).robot.grip, 10'000.0);
  EXPECT_THAT(reasons(read({"", "grip = 9999", ""})), ElementsAre(Says("grip", "9999 mm/s²", "10000 mm/s²")));
  for (const std::string odd : {"99", "200001", "-1"})
    EXPECT_THAT(reasons(read({"", "grip = " + odd, ""})),
                ElementsAre(Says("'curve.grip'", odd, "100 to 200000 mm/s²")));
  EXPECT_THAT(reasons(read({"", "grip = 12000\nyaw_jerk = 9000", ""})), ElementsAre(Says("yaw jerk", "grip")));
}

TEST(RobotChoices, AreGripOfAtLeastEveryAccelerationOfStraights) {
  // Each of the four in turn is the largest.
  for (const std::string small : {"= 8000", "= 9000", "= 7000", "= 6000"}) {
    std::string text = text_of({"", "grip = 11000", ""});
    EXPECT_TRUE(read_robot(text, "mine").robot);
    text.replace(text.find(small), small.size(), "= 11001");
    EXPECT_THAT(reasons(read_robot(text, "mine")), ElementsAre(Says("grip", "11000 mm/s²", "11001 mm/s²"))) << small;
  }
}

TEST(RobotChoices, AreALimitOfTheYawSpeed) {
  constexpr double limit = 6.0;
  const DriveModel free = model_of({}), limited = model_of({"", fmt::format("yaw_speed = {}", limit), ""});
  EXPECT_EQ(limited.robot.yaw_speed, limit);
  const auto fastest = [](const DriveModel& model) {
    double rate = 0.0;
    for (std::size_t i = 0; i < model.shapes.size(); ++i)
      rate = std::max(rate, model.shapes[i].ramp.peak * model.tables.turns[i].speed);
    return rate;
  };
  EXPECT_GT(fastest(free), limit);
  EXPECT_NEAR(fastest(limited), limit, 1e-9);
  EXPECT_THAT(reasons(read({"", "yaw_speed = 0.05", ""})), ElementsAre(Says("'curve.yaw_speed'", "0.1 to 100 rad/s")));
  EXPECT_THAT(reasons(read({"", "yaw_speed = 1146", ""})),
              ElementsAre(Says("'curve.yaw_speed'", "0.1 to 100 rad/s", "degrees/s", "write 20")));
}

TEST(RobotChoices, AreTheProfileOfTurns) {
  EXPECT_EQ(model_of({"", "profile = \"trapezoid\"", ""}).tables.hash, model_of({}).tables.hash);
  const auto hardest = [](const DriveModel& model) {
    double most = 0.0;
    for (std::size_t i = 0; i < model.shapes.size(); ++i) {
      const double speed = model.tables.turns[i].speed;
      const RampPath& ramp = model.shapes[i].ramp;
      most = std::max(most, ramp.growth_at(ramp.length / 2.0) * speed * speed);
    }
    return most;
  };
  for (std::size_t i = 0; i < turn_profile_names.size(); ++i) {
    const DriveModel model = model_of({"", fmt::format("profile = \"{}\"", turn_profile_names[i]), ""});
    EXPECT_EQ(model.robot.profile, static_cast<TurnProfile>(i));
    if (model.robot.profile == TurnProfile::free) continue;  // whose paths have no ramp
    EXPECT_NEAR(hardest(model), 300.0, 1e-9) << turn_profile_names[i];
  }
  EXPECT_TRUE(read({"", "profile = \"sine\"\ngrip = 12000", ""}).robot);
  for (const std::string odd : {"\"Sine\"", "\"\"", "1", "true"})
    EXPECT_THAT(reasons(read({"", "profile = " + odd, ""})),
                ElementsAre(Says("'curve.profile'", "\"trapezoid\", \"sine\", \"cubic\" or \"free\"")))
        << odd;
}

TEST(RobotChoices, AreWhetherDiagonalsAreDriven) {
  const DriveModel square = model_of({"diagonals = false"});
  for (const Turn turn : all_turns)
    EXPECT_EQ(has_turn(square.tables, turn), !begins_diagonal(turn) && !ends_diagonal(turn)) << name_of(turn);
  EXPECT_EQ(square.tables.diagonal.count(), 0U);
  for (const std::string odd : {"0", "\"no\"", "nan"})
    EXPECT_THAT(reasons(read({"diagonals = " + odd})), ElementsAre(Says("'diagonals'", "true or false"))) << odd;
  for (const std::string turn : {"45", "135", "V90"})
    for (const std::string value : {"false", "900"})
      EXPECT_THAT(reasons(read({"diagonals = false", "", fmt::format("{} = {}", turn, value)})),
                  ElementsAre(Says("'layout." + turn + "'", "without diagonals")));
}

TEST(RobotChoices, AreWhichTurnsAreDriven) {
  for (const Turn out : {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90}) {
    const DriveTables tables = model_of({"", "", fmt::format("{} = false", name_of(out))}).tables;
    for (const Turn turn : all_turns)
      EXPECT_EQ(has_turn(tables, turn), turn != out && turn != reversed(out)) << name_of(out) << ": " << name_of(turn);
    EXPECT_THAT(reasons(read({"", "", fmt::format("{} = true", name_of(out))})),
                ElementsAre(Says(fmt::format("'layout.{}'", name_of(out)), "number")));
  }
  EXPECT_THAT(reasons(read({"", "", "S90 = false"})), ElementsAre(Says("'layout.S90'", "number")));
}

/// All that limits decide is nothing to a robot of given times.
TEST(RobotChoices, AreRefusedBesideGivenTimes) {
  const auto text = std::find_if(builtin_robots().begin(), builtin_robots().end(), [](const BuiltinRobot& robot) {
                      return robot.name == "mm2021";
                    })->text;
  for (const std::string key : {"speeds = 4", "grip = 12000", "yaw_speed = 9", "yaw_jerk = 9000", "profile = \"sine\""})
    EXPECT_THAT(reasons(read_robot(fmt::format("{}\n[curve]\n{}\n", text, key), "mine")),
                ElementsAre(Says("'curve." + key.substr(0, key.find(' ')) + "'", "[turns]")));
  EXPECT_THAT(reasons(read_robot(fmt::format("stop = \"goal\"\n{}", text), "mine")),
              ElementsAre(Says("'stop'", "[turns]")));
}

/// What a record makes of a robot.
DriveModel recorded(const Robot& robot) {
  const ReadJson json = ReadJson::parse(robot_json(robot).dump());
  JsonFields fields(json, "");
  DriveModel model = read_robot_json(fields, json);
  EXPECT_EQ(fields.error(), "");
  return model;
}

void expect_kept(std::string_view text) {
  SCOPED_TRACE(text);
  const RobotResult result = read_robot(text, "mine");
  ASSERT_TRUE(result.robot);
  const DriveModel again = recorded(*result.robot);
  EXPECT_EQ(again.tables.hash, result.model.tables.hash);
  EXPECT_EQ(again.search, result.model.search);
  EXPECT_EQ(again.robot.sight, result.robot->sight);
  EXPECT_EQ(again.robot.diagonals, result.robot->diagonals);
  EXPECT_EQ(again.robot.layouts, result.robot->layouts);
  EXPECT_EQ(robot_json(again.robot), robot_json(*result.robot));
  if (result.robot->fixed) return;  // these mean nothing to it
  EXPECT_EQ(again.robot.speeds, result.robot->speeds);
  EXPECT_EQ(again.robot.stop, result.robot->stop);
}

TEST(RobotChoices, AreKeptInRecords) {
  for (int speeds = 1; speeds <= most_speeds; ++speeds)
    expect_kept(text_of({"stop = \"beyond\"", fmt::format("speeds = {}", speeds), ""}));
  for (const Lines& lines : {Lines{}, Lines{"stop = \"goal\"", "speeds = 2", ""}, Lines{"", "grip = 10500.25", ""},
                             Lines{"", "yaw_speed = 6.1", ""}, Lines{"", "profile = \"cubic\"", ""},
                             Lines{"", "yaw_speed = 7\nyaw_jerk = 9000", ""}, Lines{"diagonals = false"},
                             Lines{"diagonals = false", "grip = 1e4", "180 = false"},
                             Lines{"sight = 3", "", "45 = false\n90 = false\n135 = false\n180 = false\nV90 = false"},
                             Lines{"", "", "V90 = 950\n180 = 60.5\nS90 = 800"}})
    expect_kept(text_of(lines));
}

TEST(RobotChoices, AreKeptInRecordsOfEachRobotThatComesWithTheProgram) {
  for (const BuiltinRobot& robot : builtin_robots()) expect_kept(robot.text);
}

}  // namespace
}  // namespace labmouse
