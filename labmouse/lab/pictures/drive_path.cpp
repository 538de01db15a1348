#include "labmouse/lab/pictures/drive_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace labmouse {
namespace {

constexpr int pieces_a_turn = 12;
/// Least number of points per cell where the speed changes.
constexpr int points_a_cell = 4;

/// Appends a point and sets the acceleration of the last one. A point at the same time and speed replaces the last one.
void append(std::vector<DrivePathPoint>& points, const DrivePathPoint& point) {
  constexpr double same_speed = 0.5;  // mm/s
  if (!points.empty()) {
    DrivePathPoint& last = points.back();
    last.acceleration = 0.0;
    if (point.time > last.time) last.acceleration = (point.speed - last.speed) / ((point.time - last.time) / 1e6);
    if (point.time <= last.time && std::abs(point.speed - last.speed) < same_speed) points.pop_back();
  }
  points.push_back(point);
}

/// Times within a segment, from its begin to its end, at which points are made.
std::vector<double> moments_of(const DriveProfile& profile, bool turns, double cell) {
  const auto [up, down] = profile.changes();
  const double end = profile.duration();
  std::vector<double> moments = {0.0};
  for (const double change : {up, down, end}) {
    const double begin = moments.back();
    if (change <= begin) continue;
    const bool even = profile.speed_at(begin) == profile.speed_at(change);
    const double cells = (profile.distance_at(change) - profile.distance_at(begin)) / cell;
    const int pieces = turns ? pieces_a_turn : even ? 1 : 1 + static_cast<int>(cells * points_a_cell);
    for (int i = 1; i <= pieces; ++i) moments.push_back(begin + (change - begin) * i / pieces);
  }
  return moments;
}

/// Makes the points of a search run: straights, quarter circles and turns in place.
class SearchPath {
 public:
  SearchPath(const DriveModel& model, const SearchPlace& place, std::vector<DrivePathPoint>& points)
      : model_(model), search_(model.search), speed_(model.tables.cell / (search_.cell / 1e6)), points_(points) {
    const Cell ahead = neighbour(Cell{0, 0}, place.pose.heading);
    const double back = place.at_rest ? 0.0 : 0.5;
    at_.x = place.pose.cell.x + 0.5 - back * ahead.x;
    at_.y = place.pose.cell.y + 0.5 - back * ahead.y;
    at_.heading = eighths(place.pose.heading);
    at_.speed = place.at_rest ? 0.0 : speed_;
  }

  void begin(MazeTime time) {
    at_.time = static_cast<double>(time);
    append(points_, at_);
  }

  void move(const SearchMove& move, bool at_rest) {
    const double quarters = move.action.rotation / 90.0;
    at_.time = static_cast<double>(move.begin);
    const std::size_t first = points_.size();
    append(points_, at_);
    if (move.action.movement == 0)
      look_about(quarters, at_rest);
    else if (move.action.movement == 1)
      leave(quarters, at_rest);
    else
      dash(move.action.movement);
    fit(first, move);
  }

 private:
  void look_about(double quarters, bool at_rest) {
    if (!at_rest) straight(0.5, search_.half_cell, speed_, 0.0);
    pivot(quarters, std::abs(quarters) * search_.quarter);
  }

  /// Drives to the middle of the side by which the robot leaves its cell.
  void leave(double quarters, bool at_rest) {
    if (at_rest) {
      pivot(quarters, std::abs(quarters) * search_.quarter);
      straight(0.5, search_.half_cell, 0.0, speed_);
    } else if (quarters == 0.0) {
      ahead(1.0, search_.cell, speed_);
    } else if (std::abs(quarters) == 1.0) {
      quarter_circle(quarters);
    } else {
      const double stop = std::min<double>(search_.half_cell, search_.back / 2.0);
      straight(0.5, stop, speed_, 0.0);
      pivot(quarters, search_.back - 2.0 * stop);
      straight(0.5, stop, 0.0, speed_);
    }
  }

  /// Drives fast over known cells, each at its mean speed.
  void dash(int cells) {
    for (int edge = 1; edge <= cells; ++edge) {
      const double time = search_.dash_part(cells, edge) - search_.dash_part(cells, edge - 1);
      ahead(1.0, time, edge < cells ? model_.tables.cell / (time / 1e6) : speed_);
    }
  }

  /// Drives that distance in cells to or from rest: at constant search speed, and with constant acceleration for the
  /// remaining time.
  void straight(double cells, double time, double from, double to) {
    const double changing = std::clamp(2.0 * (time - cells * model_.tables.cell / speed_ * 1e6), 0.0, time);
    const double slow = speed_ / 2.0 * changing / 1e6 / model_.tables.cell;
    if (from > to) ahead(cells - slow, time - changing, from);
    ahead(slow, changing, to);
    if (from < to) ahead(cells - slow, time - changing, to);
  }

  /// Drives straight on with constant acceleration from the present speed to `speed`.
  void ahead(double cells, double time, double speed) {
    const double angle = at_.heading * std::numbers::pi / 4.0;
    at_.x += cells * std::sin(angle);
    at_.y += cells * std::cos(angle);
    at_.time += time;
    at_.speed = speed;
    append(points_, at_);
  }

  void pivot(double quarters, double time) {
    at_.heading += 2.0 * quarters;
    at_.time += time;
    at_.speed = 0.0;
    append(points_, at_);
  }

  /// A quarter circle within a cell: to the right if `side` is 1, to the left if it is -1.
  void quarter_circle(double side) {
    const double radius = 0.5, begin = at_.heading * std::numbers::pi / 4.0;
    const double middle_x = at_.x + side * radius * std::cos(begin), middle_y = at_.y - side * radius * std::sin(begin);
    const double time = search_.turn / static_cast<double>(pieces_a_turn);
    at_.speed = radius * model_.tables.cell * std::numbers::pi / 2.0 / (search_.turn / 1e6);
    append(points_, at_);
    for (int i = 1; i <= pieces_a_turn; ++i) {
      const double angle = begin + side * i * std::numbers::pi / 2.0 / pieces_a_turn;
      at_.heading += side * 2.0 / pieces_a_turn;
      at_.x = middle_x - side * radius * std::cos(angle);
      at_.y = middle_y + side * radius * std::sin(angle);
      at_.time += time;
      append(points_, at_);
    }
    at_.speed = speed_;
  }

  /// Scales the times of a move's points to its recorded duration.
  void fit(std::size_t first, const SearchMove& move) {
    const double begin = static_cast<double>(move.begin), took = at_.time - begin;
    const double scale = took > 0.0 ? static_cast<double>(move.end - move.begin) / took : 1.0;
    for (std::size_t i = first; i < points_.size(); ++i) points_[i].time = begin + (points_[i].time - begin) * scale;
    at_.time = static_cast<double>(move.end);
  }

  const DriveModel& model_;
  const SearchDrive& search_;
  double speed_;
  std::vector<DrivePathPoint>& points_;
  DrivePathPoint at_;
};

/// The points of a route, at that pace, up to the end of its run.
std::vector<DrivePathPoint> as_driven(std::vector<DrivePathPoint> points, const DriveRun& run, double pace) {
  const double begin = static_cast<double>(run.begin), end = static_cast<double>(run.end);
  for (DrivePathPoint& point : points) {
    point.time = begin + (point.time - begin) / pace;
    point.speed *= pace;
    point.acceleration *= pace * pace;
  }
  // A point after the end by rounding only is kept.
  constexpr double rounding = 1.0;
  while (!points.empty() && points.back().time > end + rounding) points.pop_back();
  return points;
}

}  // namespace

std::vector<DrivePathPoint> path_of(const DriveRoute& route, MazeTime begin, const DriveModel& model) {
  const double cell = model.tables.cell;
  std::vector<DrivePathPoint> points;
  double heading = 0.0;
  for (std::size_t i = 0; i < route.segments.size(); ++i) {
    const DriveSegment& segment = route.segments[i];
    const DriveProfile profile(model, route, i);
    const double from = static_cast<double>(begin + segment.begin);
    for (const double moment : moments_of(profile, segment.kind == DriveSegment::Kind::turn, cell)) {
      const DriveSpot spot = profile.spot(profile.distance_at(moment));
      const double direction = spot.angle * 4.0 / std::numbers::pi;
      heading = points.empty() ? direction : heading + std::remainder(direction - heading, 8.0);
      append(points, {from + moment, spot.x / cell, spot.y / cell, heading, profile.speed_at(moment), 0.0});
    }
  }
  return points;
}

std::vector<DrivePathPoint> DrivePath::follow(const DriveRun& run, double pace) {
  if (run.has_route()) {
    place_ = start_;
    if (!run.route.segments.empty()) {
      const DriveNode& last = run.route.segments.back().to;
      place_ = {{last.cell, last.heading}, true};
    }
    return as_driven(path_of(run.route, run.begin, model_), run, pace);
  }
  if (run.kind == DriveRun::Kind::search) place_ = start_;
  std::vector<DrivePathPoint> points;
  SearchPath path(model_, place_, points);
  path.begin(run.begin);
  for (const SearchMove& move : run.moves) {
    path.move(move, place_.at_rest);
    place_ = after_search(place_, move.action);
  }
  return points;
}

}  // namespace labmouse
