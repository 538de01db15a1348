#include "labmouse/lab/robots/robot_arrays.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/robots/robot_table.hpp"

namespace labmouse {
namespace {

// The rows of numbers by the names of the arrays.
std::map<std::string, std::vector<std::array<double, 8>>> arrays_in(const std::string& text) {
  std::map<std::string, std::vector<std::array<double, 8>>> arrays;
  std::istringstream lines(text);
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    const std::string before = "static const struct labmouse_turn ";
    if (line.starts_with(before)) name = line.substr(before.size(), line.find('[') - before.size());
    std::array<double, 8> row{};
    if (std::sscanf(line.c_str(), " {%lff, %lff, %lff, %lff, %lff, %lff, %lff, %lff}", &row[0], &row[1], &row[2],
                    &row[3], &row[4], &row[5], &row[6], &row[7]) == 8)
      arrays[name].push_back(row);
  }
  return arrays;
}

TEST(RobotArrays, TurnByTheAnglesOfTheTurnsInTheirTimes) {
  const std::map<std::string, double> angles = {{"SD45", 45},   {"SS90", 90}, {"SD135", 135},
                                                {"SS180", 180}, {"DD90", 90}, {"SS90E", 90}};
  for (const char* name : {"classic", "half"}) {
    const FoundRobot found = find_robot(name);
    const auto arrays = arrays_in(robot_arrays(found.robot, found.model, all_turn_names()[1]));
    std::size_t rows = 0;
    for (const auto& [turn, speeds] : arrays) {
      ASSERT_TRUE(angles.contains(turn)) << turn;
      for (const auto& [speed, lead_in, lead_out, curve, ramp, rate, acceleration, time] : speeds) {
        // The yaw rate rises and falls steadily, so that a ramp counts half.
        EXPECT_NEAR(rate * (curve - ramp) / speed, angles.at(turn), 0.2) << name << ' ' << turn;
        EXPECT_NEAR(acceleration * ramp / speed, rate, 0.5);
        EXPECT_GE(time, 0.99 * curve / speed * 1e3);
        ++rows;
      }
    }
    EXPECT_EQ(rows, shown_turns(found.model).size());
    EXPECT_EQ(arrays.at("SS90").front()[0] > arrays.at("SS90").back()[0], true);
  }
}

TEST(RobotArrays, HaveTheNamesOfAConvention) {
  const FoundRobot found = find_robot("classic");
  for (const TurnNames& names : all_turn_names())
    for (const Turn turn : {Turn::f45, Turn::f90, Turn::f135, Turn::f180, Turn::v90, Turn::s90}) {
      const std::string name(names.of[static_cast<unsigned>(turn)]);
      EXPECT_TRUE(arrays_in(robot_arrays(found.robot, found.model, names)).contains(name)) << names.name << name;
    }
}

TEST(RobotArrays, SayWhichProfileTheirRampsHave) {
  FoundRobot found = find_robot("classic");
  const auto head = [&] {
    const std::string text = robot_arrays(found.robot, found.model, all_turn_names()[0]);
    return text.substr(0, text.find("*/"));
  };
  EXPECT_EQ(head().find("trapezoid"), std::string::npos);
  for (const TurnProfile profile : {TurnProfile::sine, TurnProfile::cubic}) {
    found.robot.profile = profile;
    EXPECT_NE(head().find(name_of(profile)), std::string::npos);
  }
}

/// The curvature of a free path, summed along it, turns by the angle of the turn.
TEST(RobotArrays, HaveTheCurvatureOfFreePaths) {
  Robot robot = find_robot("classic").robot;
  robot.profile = TurnProfile::free;
  std::istringstream lines(robot_arrays(robot, make_drive_model(robot), all_turn_names()[0]));
  std::string name;
  std::map<std::string, double> angles;
  double place_before = 0.0, curvature_before = 0.0;
  for (std::string line; std::getline(lines, line);) {
    const std::string before = "static const float ";
    if (line.starts_with(before)) name = line.substr(before.size(), line.find('[') - before.size()), place_before = 0.0;
    if (line == "};") name.clear();
    double place = 0.0, curvature = 0.0;
    if (name.empty() || std::sscanf(line.c_str(), " {%lff, %lff}", &place, &curvature) != 2) continue;
    angles[name] += (place - place_before) * (curvature + curvature_before) / 2e3;
    place_before = place, curvature_before = curvature;
  }
  for (const auto& [turn, eighth] : std::map<std::string, int>{{"TURN_45", 1}, {"TURN_90", 2}, {"TURN_180", 4}})
    for (const char* speed : {"_curvature_0", "_curvature_1"})
      EXPECT_NEAR(angles[turn + speed], eighth * 0.785398, 0.002) << turn << speed;
}

TEST(RobotArrays, DoNotEndTheirCommentWithTheNameOfARobot) {
  FoundRobot found = find_robot("classic");
  found.robot.name = "a */ int b; /*";
  const std::string text = robot_arrays(found.robot, found.model, all_turn_names()[0]);
  EXPECT_LT(text.find("int b"), text.find("*/"));
}

}  // namespace
}  // namespace labmouse
