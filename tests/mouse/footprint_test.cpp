// The body of a robot on its fastest routes: that it touches no wall and no post, where half its width is the robot's
// clearance less half the diagonal of a post.
//
// A route is laid out as one path, from where the robot stands before its start: each straight and each curve begins
// where the last one ended, so that a gap between two of them would show. Lengths are mm; directions are rad
// counterclockwise from east.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "labmouse/mouse/drive/fastest.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"
#include "tests/capstone_mazes.hpp"
#include "tests/mouse/drive_robots.hpp"
#include "tests/mouse/robot_parameters.hpp"
#include "tests/slowness.hpp"
#include "tests/strategies/random_mazes.hpp"

namespace labmouse {
namespace {

using test::builtin;
using test::PrintRobot;

constexpr double far_away = std::numeric_limits<double>::infinity();

struct Point {
  double x = 0.0, y = 0.0;
};

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A place on a path and the direction there.
struct Spot {
  Point place;
  double direction = 0.0;

  Spot ahead(double way) const {
    return {{place.x + way * std::cos(direction), place.y + way * std::sin(direction)}, direction};
  }
};

Spot spot_of(const DriveNode& node, double cell) {
  const double north = std::numbers::pi / 2.0;
  Spot spot{{(node.cell.x + 0.5) * cell, (node.cell.y + 0.5) * cell}, north * (1 - static_cast<int>(node.heading))};
  if (node.place == Place::centre) return spot;
  spot = spot.ahead(cell / 2.0);
  if (node.place == Place::left) spot.direction += north / 2.0;
  if (node.place == Place::right) spot.direction -= north / 2.0;
  return spot;
}

/// A path in points at most a mm apart.
class Path {
 public:
  explicit Path(const Spot& start) : spots_{start} {}

  const std::vector<Spot>& spots() const { return spots_; }
  const Spot& end() const { return spots_.back(); }

  void go_straight(double length) { go(length, 0.0, 0.0, 0.0); }

  /// A curve of that shape, by how its curvature grows: it rises, as evenly as its onsets let it, stays, and falls.
  void turn(const TurnShape& shape, bool left) {
    const auto [ramp, onset, peak, profile] = shape.ramp;
    const double most = (left ? peak : -peak) / (ramp - onset), change = onset > 0.0 ? most / onset : 0.0;
    go(onset, 0.0, 0.0, change);
    go(ramp - 2.0 * onset, curvature_, most, 0.0);
    go(onset, curvature_, most, -change);
    go(shape.length - 2.0 * ramp, curvature_, 0.0, 0.0);
    go(onset, curvature_, 0.0, -change);
    go(ramp - 2.0 * onset, curvature_, -most, 0.0);
    go(onset, curvature_, -most, change);
  }

 private:
  /// A part on which the curvature begins with a value and grows by so much a mm, and that by so much a mm.
  void go(double length, double curvature, double growth, double change) {
    const int steps = static_cast<int>(std::ceil(length));
    const double step = length / std::max(1, steps);
    for (int i = 0; i < steps; ++i) {
      const Spot from = spots_.back();
      const auto direction_after = [&](double way) {
        return from.direction + way * (curvature + way * (growth / 2.0 + way * change / 6.0));
      };
      const double middle = direction_after(step / 2.0), last = direction_after(step);
      const auto mean = [&](double (*of)(double)) { return (of(from.direction) + 4.0 * of(middle) + of(last)) / 6.0; };
      const double x = step * mean([](double it) { return std::cos(it); });
      const double y = step * mean([](double it) { return std::sin(it); });
      spots_.push_back({{from.place.x + x, from.place.y + y}, last});
      curvature += step * (growth + step * change / 2.0);
      growth += step * change;
    }
    curvature_ = curvature;
  }

  std::vector<Spot> spots_;
  double curvature_ = 0.0;  ///< where the last part ended
};

void expect_meets(const Spot& end, const Spot& node) {
  EXPECT_LT(distance(end.place, node.place), 0.1);
  EXPECT_LT(std::abs(std::remainder(end.direction - node.direction, 2.0 * std::numbers::pi)), 1e-4);
}

/// The leads of the turn before and after a straight.
std::array<double, 2> leads_about(const DriveModel& model, const DriveRoute& route, std::size_t i) {
  const DriveTables& tables = model.tables;
  const auto& lanes = (route.segments[i].from.diagonal() ? tables.diagonal : tables.along).lanes;
  const bool last = i + 1 == route.segments.size();
  return {i == 0 ? model.robot.run_up : lanes[tables.turns[route.segments[i - 1].turn].to].lead,
          last ? 0.0 : lanes[tables.turns[route.segments[i + 1].turn].from].lead};
}

/// From rest to the goal, and on to where it can stand. Every segment must end at its node, or a lead beside it.
Path path_of(const DriveModel& model, const DriveRoute& route) {
  const double cell = model.tables.cell;
  Path path(spot_of(route.segments.front().from, cell).ahead(-model.robot.run_up));
  double lead = 0.0;
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveSegment& segment = route.segments[i];
    if (segment.kind == DriveSegment::Kind::turn) {
      const TurnShape& shape = model.shapes[segment.turn];
      path.turn(shape, segment.left);
      lead = shape.lead_out;
    } else {
      const double unit = segment.from.diagonal() ? cell / std::numbers::sqrt2 : cell / 2.0;
      const auto [before, after] = leads_about(model, route, i);
      path.go_straight(before + segment.units * unit + after);
      lead = -after;
    }
    expect_meets(path.end().ahead(lead), spot_of(segment.to, cell));
  }
  path.go_straight(stopping_room(route, model.tables) * cell);
  return path;
}

/// How near a point comes to what stands in a maze.
struct Nearest {
  double wall = far_away;       ///< to the face of a wall, from post to post
  double post = far_away;       ///< to a square post
  double post_axis = far_away;  ///< to the middle of one
};

/// A maze of walls as thick as 12 mm in cells of 180, with a post at each corner of a cell.
class Walls {
 public:
  Walls(const Maze& maze, double cell) : maze_(maze), cell_(cell), half_(half_thickness(cell)) {}

  static double half_thickness(double cell) { return cell * 6.0 / 180.0; }

  /// The wall on the back of the start is left out where the robot stands before it: that is up to its tail.
  Nearest nearest(Point point, bool at_start) const {
    Nearest nearest;
    const int x = static_cast<int>(std::floor(point.x / cell_)), y = static_cast<int>(std::floor(point.y / cell_));
    for (int i = x - 1; i <= x + 1; ++i)
      for (int j = y - 1; j <= y + 1; ++j) look(Cell{i, j}, point, at_start, nearest);
    return nearest;
  }

 private:
  /// The northern and the eastern wall of a cell, and the post between them.
  void look(Cell cell, Point point, bool at_start, Nearest& nearest) const {
    const Point corner = {(cell.x + 1) * cell_, (cell.y + 1) * cell_};
    nearest.post = std::min(nearest.post, to_box(point, corner, half_, half_));
    nearest.post_axis = std::min(nearest.post_axis, distance(point, corner));
    const double long_half = cell_ / 2.0 - half_;
    if (stands(wall_at(cell, Heading::north), at_start))
      nearest.wall = std::min(nearest.wall, to_box(point, {corner.x - cell_ / 2.0, corner.y}, long_half, half_));
    if (stands(wall_at(cell, Heading::east), at_start))
      nearest.wall = std::min(nearest.wall, to_box(point, {corner.x, corner.y - cell_ / 2.0}, half_, long_half));
  }

  bool stands(Wall wall, bool at_start) const {
    const Cell behind = neighbour(wall.cell, wall.side);
    const bool inside = maze_.size().contains(wall.cell) || maze_.size().contains(behind);
    if (!inside || (at_start && wall == wall_at(maze_.start(), opposite(maze_.start_heading())))) return false;
    return on_border(wall, maze_.size()) || !maze_.open_walls().contains(wall);
  }

  static double to_box(Point point, Point middle, double half_width, double half_height) {
    return std::hypot(std::max(0.0, std::abs(point.x - middle.x) - half_width),
                      std::max(0.0, std::abs(point.y - middle.y) - half_height));
  }

  const Maze& maze_;
  double cell_, half_;
};

Nearest nearest_on(const Path& path, const Walls& walls, double run_up) {
  Nearest all;
  for (const Spot& spot : path.spots()) {
    const bool at_start = distance(spot.place, path.spots().front().place) < run_up;
    const Nearest here = walls.nearest(spot.place, at_start);
    all = {std::min(all.wall, here.wall), std::min(all.post, here.post), std::min(all.post_axis, here.post_axis)};
  }
  return all;
}

class Footprint : public testing::TestWithParam<Robot> {
 protected:
  Footprint() : model_(make_drive_model(GetParam())) {}
  void SetUp() override {
    ASSERT_EQ(model_.error, "");
    share_route_tables(model_);
  }

  /// Drives the fastest route of a maze, if there is one.
  void expect_room_in(const Maze& maze) {
    FastestRoutes routes(maze.size(), route_tables_of(model_));
    DriveRoute route;
    routes.fill(maze.open_walls(), maze.goals());
    routes.route_from({maze.start(), maze.start_heading()}, route);
    if (route.segments.empty()) return;
    ++routes_;
    const Robot& robot = GetParam();
    const Nearest nearest = nearest_on(path_of(model_, route), Walls(maze, robot.cell), robot.run_up);
    // Points a mm apart miss the nearest one by less than that.
    constexpr double hair = 0.01;
    const double half_wall = Walls::half_thickness(robot.cell);
    EXPECT_GT(nearest.wall, robot.clearance - half_wall - hair);
    EXPECT_GT(nearest.post_axis, robot.clearance - hair);
    // Posts are square, and their corners stand out.
    EXPECT_GT(nearest.post, robot.clearance - std::numbers::sqrt2 * half_wall - hair);
  }

  DriveModel model_;
  int routes_ = 0;
};

TEST_P(Footprint, TouchesNothingInRealMazes) {
  const auto files = test::maze_files();
  if (files.empty()) GTEST_SKIP() << "no maze files in " << test::folder_of_mazes() << "; set LABMOUSE_MAZES";
  for (std::size_t i = 0; i < files.size(); i += static_cast<std::size_t>(2 * test::slowness)) {
    const auto maze = test::maze_in_file(files[i]);
    if (!maze || maze->size().width > max_drive_side || maze->size().height > max_drive_side) continue;
    SCOPED_TRACE(files[i]);
    expect_room_in(*maze);
  }
  EXPECT_GT(routes_, 0);
}

TEST_P(Footprint, TouchesNothingInMazesByDice) {
  Rng rng(21);
  for (int i = 0; i < test::some_of(160); ++i) {
    const Maze maze = test::any_maze(rng, 20);
    SCOPED_TRACE(test::drawing_of(maze));
    expect_room_in(maze);
    if (HasFailure()) return;
  }
  EXPECT_GT(routes_, 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, Footprint,
                         testing::Values(builtin("beginner"), builtin("classic"), builtin("half"), builtin("kerise"),
                                         fan_robot(), jerk_robot(), large_jerk_robot(), grip_robot(),
                                         small_grip_robot(), unstopped_robot(), square_robot(), slow_robot(),
                                         strong_robot(), slow_to_turn(), smooth_robot(), slow_on_diagonals(),
                                         robot_of_speeds<1>()),
                         PrintRobot());

}  // namespace
}  // namespace labmouse
