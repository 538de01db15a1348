#include "labmouse/mouse/robot/turn_room.hpp"

#include <algorithm>
#include <cmath>

#include "labmouse/functions/position.hpp"

namespace labmouse {
namespace {

constexpr Cell origin{2, 2};
constexpr Heading ahead = Heading::north;
constexpr Heading side = Heading::west;
constexpr Heading behind = Heading::south;

constexpr Cell next = neighbour(origin, ahead);
constexpr Cell across = neighbour(next, side);
constexpr Cell beside = neighbour(origin, side);

/// Onto the wall `crossed` of a cell, crossing the wall `second` of the next cell after it.
constexpr DriveNode diagonal_node(Cell cell, Heading crossed, Heading second) {
  return {cell, crossed, second == left_of(crossed) ? Place::left : Place::right};
}

TurnRoom room_between(Turn turn) {
  const DriveNode centre{origin, ahead, Place::centre};
  std::vector<Wall> corner = {wall_at(origin, ahead), wall_at(next, side)};
  const auto with = [&corner](std::vector<Wall> more) {
    more.insert(more.begin(), corner.begin(), corner.end());
    return more;
  };
  switch (turn) {
    case Turn::f45:
      return {centre, diagonal_node(next, side, ahead), with({wall_at(across, ahead)}), {}};
    case Turn::f90:
      return {centre, {across, side, Place::centre}, corner, {}};
    case Turn::f135:
      return {centre, diagonal_node(across, behind, side), with({wall_at(across, behind), wall_at(beside, side)}), {}};
    case Turn::f180:
      return {centre, {beside, behind, Place::centre}, with({wall_at(across, behind)}), {}};
    case Turn::v90:
      return {diagonal_node(origin, ahead, side),
              diagonal_node(across, behind, side),
              with({wall_at(across, behind), wall_at(beside, side)}),
              {}};
    default:
      return {{origin, ahead, Place::edge}, {next, side, Place::edge}, corner, {}};
  }
}

/// All walls around the cells that turns pass, except the open ones.
std::vector<Wall> others(const std::vector<Wall>& open) {
  std::vector<Wall> walls;
  for (int y = origin.y - 2; y <= origin.y + 3; ++y)
    for (int x = origin.x - 3; x <= origin.x + 2; ++x)
      for (const Wall wall : {wall_at({x, y}, Heading::north), wall_at({x, y}, Heading::east)})
        if (std::find(open.begin(), open.end(), wall) == open.end()) walls.push_back(wall);
  return walls;
}

}  // namespace

TurnRoom room_of(Turn turn) {
  const bool back = turn == Turn::out45 || turn == Turn::out135;
  TurnRoom room = room_between(back ? reversed(turn) : turn);
  room.standing = others(room.open);
  return room;
}

MazePoint maze_point(const DriveNode& from, bool left, const PathPoint& point, double cell) {
  const auto [east, north] = way_of_eighths(eighths(from));
  const double aside = left ? point.aside : -point.aside;
  const HalfPoint start = half_point(from);
  return {start.x / 2.0 + (point.ahead * east - aside * north) / cell,
          start.y / 2.0 + (point.ahead * north + aside * east) / cell};
}

double distance(MazePoint point, Wall wall) {
  const bool level = wall.side == Heading::north;
  const MazePoint corner = {wall.cell.x + 1.0, wall.cell.y + 1.0};
  const double along = level ? corner.x - point.x : corner.y - point.y;
  const double off = level ? corner.y - point.y : corner.x - point.x;
  const double past = std::max({0.0, -along, along - 1.0});
  return std::sqrt(past * past + off * off);
}

double clearance_of(const TurnShape& shape, double cell) {
  const TurnRoom room = room_of(shape.turn);
  const auto at = [&](double distance_driven) {
    const MazePoint point = maze_point(room.from, true, shape.at(distance_driven), cell);
    double nearest = 4.0;
    for (const Wall wall : room.standing) nearest = std::min(nearest, distance(point, wall));
    return nearest;
  };
  constexpr int steps = 96;
  const double step = shape.whole() / steps;
  int closest = 0;
  double nearest = at(0.0);
  for (int i = 1; i <= steps; ++i)
    if (const double here = at(step * i); here < nearest) nearest = here, closest = i;
  // The distance has one minimum between the neighbours of the closest sample: ternary search.
  double low = step * std::max(0, closest - 1);
  double high = step * std::min(steps, closest + 1);
  for (int i = 0; i < 40; ++i) {
    const double third = (high - low) / 3.0;
    if (at(low + third) < at(high - third))
      high -= third;
    else
      low += third;
  }
  return std::min(nearest, at(low)) * cell;
}

}  // namespace labmouse
