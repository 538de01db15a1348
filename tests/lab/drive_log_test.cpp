// The log that a mouse of the physical world would write.
#include "labmouse/lab/drives/drive_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "labmouse/body/body.hpp"
#include "labmouse/lab/logs/log_file.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse {
namespace {

Log read(const std::string& text) {
  const LogResult result = read_log(
      text,
      read_log_columns("time,left,right,left_count,right_count,gyro*0.00107,ir_right,ir_left,way=true_way,wall_right="
                       "true_wall_right,wall_left=true_wall_left,wall_ahead=true_wall_ahead",
                       0.0)
          .columns);
  EXPECT_THAT(result.problems, testing::IsEmpty());
  return result.log;
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
  const Log log = read(log_text(ticks, Field(maze, found.robot.cell), hardware));
  ASSERT_EQ(log.times.size(), ticks.size());
  EXPECT_EQ(ticks.size(), static_cast<std::size_t>(drive->ticks) + 500);
  EXPECT_EQ(log.times.back(), static_cast<double>(ticks.size() - 1));
  // It stands for half a second.
  for (std::size_t row = 0; row < 500; ++row) {
    EXPECT_EQ(log.of(LogRole::left)[row], 0.0);
    EXPECT_NEAR(log.of(LogRole::way)[row], 0.0, 1e-9);
  }
  const std::size_t last = log.times.size() - 1;
  const double counts = (log.of(LogRole::left_count)[last] + log.of(LogRole::right_count)[last]) / 2.0;
  EXPECT_NEAR(counts * hardware.sensors.count / log.of(LogRole::way)[last], 1.0, 0.03);
  EXPECT_GT(log.of(LogRole::way)[last], (drive->cells - 1) * found.robot.cell * 0.7);
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
  MazeDraft draft({2, 2}, MazeDraft::Inside::open);
  const Maze maze(draft);
  NoiseLevel none;
  none.all = 0.0;
  Body body(maze, 90.0, hardware, none, 1);
  const auto rows = [&](const Position& position, double angle) {
    body.put(position, angle);
    std::vector<LoggedTick> ticks;
    for (int i = 0; i < 2; ++i) {
      body.step({});
      ticks.push_back({body.sense(), {}, body.motion()});
    }
    return read(log_text(ticks, body.field(), hardware));
  };
  const Log log = rows({55.0, 135.0}, pi / 2.0);
  EXPECT_NEAR(log.of(LogRole::wall_left)[0], 52.0, 1e-3);
  EXPECT_NEAR(log.of(LogRole::wall_ahead)[0], 42.0, 1e-3);
  EXPECT_TRUE(std::isnan(log.of(LogRole::wall_right)[0]));
  EXPECT_TRUE(std::isnan(rows({55.0, 135.0}, pi / 2.0 + 0.03).of(LogRole::wall_left)[0]));  // turned
  EXPECT_TRUE(std::isnan(rows({55.0, 155.0}, pi / 2.0).of(LogRole::wall_left)[0]));         // sees a post
}

}  // namespace
}  // namespace labmouse
