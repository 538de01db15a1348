#include "labmouse/lab/pictures/robot_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_files.hpp"

namespace labmouse {
namespace {

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(RobotPicture, HasAPanelForEachKindOfTurnThatTheRobotDrives) {
  for (const BuiltinRobot& robot : builtin_robots()) {
    const FoundRobot found = find_robot(std::string(robot.name));
    ASSERT_TRUE(found.errors.empty()) << robot.name;
    const std::string svg = draw_robot(found.robot, found.model);
    // A panel has one arrow, at the end of its turn.
    EXPECT_EQ(count_of(svg, "L7 6L-7 6Z"), found.robot.diagonals ? 6 : 3) << robot.name;
  }
}

}  // namespace
}  // namespace labmouse
