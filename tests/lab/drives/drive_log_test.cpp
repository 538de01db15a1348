// The log that a mouse of the physical world would write.
#include "labmouse/lab/drives/drive_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"
#include "tests/body/body_in_a_maze.hpp"

namespace labmouse {
namespace {

/// The numbers below each heading; NaN where a field is empty.
using Columns = std::map<std::string, std::vector<double>>;

Columns read(const std::string& text) {
  Columns columns;
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line + ',');
    const bool is_heading = names.empty();
    std::size_t place = 0;
    for (std::string field; std::getline(fields, field, ','); ++place) {
      if (is_heading) {
        names.push_back(field);
        continue;
      }
      double value = std::numeric_limits<double>::quiet_NaN();
      std::from_chars(field.data(), field.data() + field.size(), value);
      columns[names.at(place)].push_back(value);
    }
  }
  return columns;
}

TEST(DriveLog, HoldsWhatTheMouseReadAndDid) {
  FoundRobot found = find_robot("kerise");
  share_route_tables(found.model);
  const MazeCollection mazes = load_builtin_mazes();
  const Maze& maze = mazes.mazes.front().maze;
  std::vector<LoggedTick> ticks;
  const auto drive = drive_known_way(maze, found.model, {}, KnownWay::search, 1, &ticks);
  ASSERT_TRUE(drive && !drive->crashed);
  const Hardware& hardware = *found.robot.hardware;
  Columns log = read(log_text(ticks, Field(maze, found.robot.cell), hardware));
  ASSERT_EQ(log["time"].size(), ticks.size());
  EXPECT_EQ(ticks.size(), static_cast<std::size_t>(drive->ticks) + 500);
  EXPECT_EQ(log["time"].back(), static_cast<double>(ticks.size() - 1));
  // It stands for half a second.
  for (std::size_t row = 0; row < 500; ++row) {
    EXPECT_EQ(log["left"][row], 0.0);
    EXPECT_NEAR(log["true_way"][row], 0.0, 1e-9);
  }
  const std::size_t last = log["time"].size() - 1;
  const double counts = (log["left_count"][last] + log["right_count"][last]) / 2.0;
  EXPECT_NEAR(counts * hardware.sensors.count / log["true_way"][last], 1.0, 0.03);
  EXPECT_GT(log["true_way"][last], (drive->cells - 1) * found.robot.cell * 0.7);
}

TEST(DriveLog, WithoutALogTheDriveIsWhatItWas) {
  FoundRobot found = find_robot("kerise");
  const MazeCollection mazes = load_builtin_mazes();
  const Maze& maze = mazes.mazes.front().maze;
  const auto drive = drive_known_way(maze, found.model, {}, KnownWay::search, 1);
  const auto again = drive_known_way(maze, found.model, {}, KnownWay::search, 1);
  ASSERT_TRUE(drive && again);
  EXPECT_EQ(drive->ticks, again->ticks);
  EXPECT_EQ(drive->truth.along, again->truth.along);
}

/// +---+---+      A mouse in the western cell, 10 mm east of its middle, heading north: walls to its left and ahead.
/// | M     |
/// +   +   +
TEST(DriveLog, KnowsWallsThatASensorSeesAlone) {
  const FoundRobot found = find_robot("kerise");
  const Hardware& hardware = *found.robot.hardware;
  test::BodyInAMaze body(Maze(MazeDraft({2, 2}, MazeDraft::Inside::open)), 90.0, hardware, no_errors);
  const auto rows = [&](const Position& position, double angle) {
    body.put(position, angle);
    std::vector<LoggedTick> ticks;
    for (int i = 0; i < 2; ++i) {
      body.step({});
      ticks.push_back({body.sense(), {}, body.motion()});
    }
    return read(log_text(ticks, body.field(), hardware));
  };
  Columns log = rows({55.0, 135.0}, pi / 2.0);
  EXPECT_NEAR(log["true_wall_left"][0], 52.0, 1e-3);
  EXPECT_NEAR(log["true_wall_ahead"][0], 42.0, 1e-3);
  EXPECT_TRUE(std::isnan(log["true_wall_right"][0]));
  EXPECT_TRUE(std::isnan(rows({55.0, 135.0}, pi / 2.0 + 0.03)["true_wall_left"][0]));  // turned
  EXPECT_TRUE(std::isnan(rows({55.0, 155.0}, pi / 2.0)["true_wall_left"][0]));         // sees a post
}

}  // namespace
}  // namespace labmouse
