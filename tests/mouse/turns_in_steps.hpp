// Turns driven in small steps of time, from a robot's limits alone.
//
// Nothing is shared with the code under test but the values of the robot and its tables. Lengths are mm, times seconds;
// a turn leads to the left from a first node in the cell between (0,0) and (1,1), in cells, and headings are degrees
// counterclockwise from east.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse::test {

inline constexpr double endless = std::numeric_limits<double>::infinity();

struct Point {
  double x = 0.0, y = 0.0;

  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
};

inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Point towards(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Where a turn begins and ends.
struct Course {
  Turn turn, back;  ///< that way and, where that is another turn, the other way round
  Point first;
  double heading;
  Point last;
  double last_heading;

  double angle() const { return (last_heading - heading) * std::numbers::pi / 180.0; }
  /// Diagonal ends lie on walls, and the next wall on that diagonal is open too.
  bool to_diagonal() const { return std::fmod(last_heading, 90.0) != 0.0; }
  bool from_diagonal() const { return std::fmod(heading, 90.0) != 0.0; }
};

inline constexpr std::array courses = {
    Course{Turn::f45, Turn::out45, {0.5, 0.5}, 90.0, {0.0, 1.5}, 135.0},
    Course{Turn::f90, Turn::f90, {0.5, 0.5}, 90.0, {-0.5, 1.5}, 180.0},
    Course{Turn::f135, Turn::out135, {0.5, 0.5}, 90.0, {-0.5, 1.0}, 225.0},
    Course{Turn::f180, Turn::f180, {0.5, 0.5}, 90.0, {-0.5, 0.5}, 270.0},
    Course{Turn::v90, Turn::v90, {0.5, 1.0}, 135.0, {-0.5, 1.0}, 225.0},
    Course{Turn::s90, Turn::s90, {0.5, 1.0}, 90.0, {0.0, 1.5}, 180.0},
};

/// A part of a curve in which the yaw jerk is constant.
struct Phase {
  double acceleration = 0.0;  ///< rad/s² at its beginning
  double jerk = 0.0;          ///< rad/s³
  double seconds = 0.0;
};

/// How finely a curve is driven.
struct Fineness {
  double step;  ///< about as many seconds
  int phases;   ///< in which a smooth curve rises
};
/// Enough to choose a speed by; and to compare with.
inline constexpr Fineness coarse{1e-3, 200}, fine{1e-4, 1600};

/// Up to a yaw rate as fast as allowed, with a yaw acceleration that is half a sine wave or a parabola, in short
/// phases.
inline std::vector<Phase> smooth_rise_to(double rate, const Robot& robot, int count) {
  const bool sine = robot.profile == TurnProfile::sine;
  std::vector<double> shares;  // of the largest yaw acceleration
  for (int i = 0; i <= count; ++i) {
    const double time = static_cast<double>(i) / count;
    shares.push_back(sine ? std::sin(std::numbers::pi * time) : 4.0 * time * (1.0 - time));
  }
  const double steepest = sine ? std::numbers::pi : 4.0;  // at both ends
  double mean = 0.0;
  for (const double share : shares) mean += share / count;
  double seconds = rate / (mean * robot.yaw_acceleration);
  if (robot.yaw_jerk > 0.0) seconds = std::max(seconds, std::sqrt(steepest * rate / (mean * robot.yaw_jerk)));
  const double most = rate / (mean * seconds), time = seconds / count;
  std::vector<Phase> phases;
  for (std::size_t i = 0; i + 1 < shares.size(); ++i)
    phases.push_back({most * shares[i], most * (shares[i + 1] - shares[i]) / time, time});
  return phases;
}

/// Up to a yaw rate as fast as allowed.
inline std::vector<Phase> rise_to(double rate, const Robot& robot, int phases) {
  if (robot.profile != TurnProfile::trapezoid) return smooth_rise_to(rate, robot, phases);
  if (robot.yaw_jerk <= 0.0) return {{robot.yaw_acceleration, 0.0, rate / robot.yaw_acceleration}};
  const double most = std::min(robot.yaw_acceleration, std::sqrt(rate * robot.yaw_jerk));
  const double change = most / robot.yaw_jerk;
  return {{0.0, robot.yaw_jerk, change}, {most, 0.0, rate / most - change}, {most, -robot.yaw_jerk, change}};
}

inline double seconds_of(const std::vector<Phase>& phases) {
  double seconds = 0.0;
  for (const Phase& phase : phases) seconds += phase.seconds;
  return seconds;
}

/// The tightest curve at a speed. While the yaw rate rises and falls, its mean is half of its largest value.
inline std::vector<Phase> curve(double angle, double speed, const Robot& robot, int count) {
  double rate = robot.lateral_acceleration / speed;
  if (robot.yaw_speed > 0.0) rate = std::min(rate, robot.yaw_speed);
  const auto turned = [&](double peak) { return peak * seconds_of(rise_to(peak, robot, count)); };
  if (turned(rate) > angle) {
    double low = 0.0;
    for (int i = 0; i < 60; ++i) (turned((low + rate) / 2.0) > angle ? rate : low) = (low + rate) / 2.0;
  }
  std::vector<Phase> phases = rise_to(rate, robot, count);
  const std::vector<Phase> rise = phases;
  phases.push_back({0.0, 0.0, std::max(0.0, angle - turned(rate)) / rate});
  for (auto it = rise.rbegin(); it != rise.rend(); ++it)
    phases.push_back({-(it->acceleration + it->jerk * it->seconds), it->jerk, it->seconds});
  return phases;
}

/// A moment of a curve.
struct Moment {
  double seconds = 0.0;
  Point place;         ///< from where the curve begins
  double angle = 0.0;  ///< rad
  double rate = 0.0;   ///< rad/s
};

/// Drives a curve in steps of about that many seconds; the way of a step by Simpson's rule.
inline std::vector<Moment> driven(const std::vector<Phase>& phases, double heading, double speed, double step) {
  Moment now;
  now.angle = heading * std::numbers::pi / 180.0;
  std::vector<Moment> moments = {now};
  for (const Phase& phase : phases) {
    const int steps = static_cast<int>(std::ceil(phase.seconds / step));
    const double time = phase.seconds / std::max(1, steps);
    for (int i = 0; i < steps; ++i) {
      const double acceleration = phase.acceleration + phase.jerk * time * i;
      const auto angle_after = [&](double t) {
        return now.angle + now.rate * t + acceleration * t * t / 2.0 + phase.jerk * t * t * t / 6.0;
      };
      const double middle = angle_after(time / 2.0), end = angle_after(time);
      now.place.x += speed * time / 6.0 * (std::cos(now.angle) + 4.0 * std::cos(middle) + std::cos(end));
      now.place.y += speed * time / 6.0 * (std::sin(now.angle) + 4.0 * std::sin(middle) + std::sin(end));
      now.angle = end;
      now.rate += acceleration * time + phase.jerk * time * time / 2.0;
      now.seconds += time;
      moments.push_back(now);
    }
  }
  return moments;
}

/// A turn laid out for a speed, with straights before and after its curve.
struct Layout {
  double speed = 0.0;
  std::vector<Phase> phases;
  std::vector<Moment> moments;
  double before = 0.0, after = 0.0;

  double length() const { return speed * seconds_of(phases); }
};

inline Layout laid_out(const Course& course, double speed, const Robot& robot, Fineness fineness) {
  Layout layout{speed, curve(course.angle(), speed, robot, fineness.phases), {}, 0.0, 0.0};
  layout.moments = driven(layout.phases, course.heading, speed, fineness.step);
  const Point rest = robot.cell * (course.last - course.first) - layout.moments.back().place;
  const Point in = towards(course.heading), out = towards(course.last_heading);
  if (std::abs(cross(in, out)) < 1e-9) return layout;  // around a post: whatever stands before and after it
  layout.before = cross(rest, out) / cross(in, out);
  layout.after = cross(in, rest) / cross(in, out);
  return layout;
}

/// A wall by the corner at its lower left end: (x, y, level).
using Place = std::tuple<int, int, bool>;

inline double distance_to(const Place& wall, Point point) {
  const auto [x, y, level] = wall;
  const double along = level ? point.x - x : point.y - y, off = level ? point.y - y : point.x - x;
  return std::hypot(off, std::max({0.0, -along, along - 1.0}));
}

/// The points of a laid out turn in cells, from node to node.
inline std::vector<Point> points_of(const Course& course, const Layout& layout, double cell) {
  const Point in = towards(course.heading), out = towards(course.last_heading);
  std::vector<Point> points;
  for (double driven = 0.0; driven < layout.before; driven += 1.0) points.push_back(driven * in);
  for (const Moment& moment : layout.moments) points.push_back(layout.before * in + moment.place);
  const Point curve_end = points.back();
  for (double driven = 0.0; driven < layout.after; driven += 1.0) points.push_back(curve_end + driven * out);
  for (Point& point : points) point = course.first + 1.0 / cell * point;
  return points;
}

/// The walls that a way between cells crosses.
inline std::set<Place> crossed(const std::vector<Point>& points) {
  std::set<Place> walls;
  const auto floor_of = [](double value) { return static_cast<int>(std::floor(value)); };
  int x = floor_of(points.front().x), y = floor_of(points.front().y);
  for (const Point& point : points) {
    const int next_x = floor_of(point.x), next_y = floor_of(point.y);
    if (next_x != x) walls.insert({std::max(x, next_x), y, false});
    if (next_y != y) walls.insert({next_x, std::max(y, next_y), true});
    x = next_x, y = next_y;
  }
  return walls;
}

/// How near a turn comes to walls that it does not cross, middle to middle, in mm; posts are their ends.
inline double clearance_of(const Course& course, const Layout& layout, double cell) {
  constexpr double hair = 1e-6;
  const std::vector<Point> points = points_of(course, layout, cell);
  std::vector<Point> way = points;
  way.insert(way.begin(), course.first - hair * towards(course.heading));
  way.push_back(course.last + hair * towards(course.last_heading));
  if (course.to_diagonal())
    way.push_back(course.last + (std::numbers::sqrt2 / 2.0 + hair) * towards(course.last_heading));
  const std::set<Place> open = crossed(way);
  double nearest = 1.0;
  for (int x = -2; x <= 2; ++x)
    for (int y = -1; y <= 3; ++y)
      for (const bool level : {false, true})
        if (const Place wall{x, y, level}; !open.contains(wall))
          for (const Point& point : points) nearest = std::min(nearest, distance_to(wall, point));
  return nearest * cell;
}

inline double top_speed(const Course& course, const Robot& robot) {
  return std::min(course.from_diagonal() ? robot.speed_diagonal : robot.speed,
                  course.to_diagonal() ? robot.speed_diagonal : robot.speed);
}

inline bool fits(const Course& course, double speed, const Robot& robot) {
  const Layout layout = laid_out(course, speed, robot, coarse);
  return layout.before >= 0.0 && layout.after >= 0.0 && clearance_of(course, layout, robot.cell) >= robot.clearance;
}

/// The speed at which a curve is a cell wide.
inline double speed_around_post(const Course& course, const Robot& robot) {
  double low = 0.0, high = 20'000.0;
  for (int i = 0; i < 60; ++i) {
    const double speed = (low + high) / 2.0;
    const bool wide = -laid_out(course, speed, robot, fine).moments.back().place.x > robot.cell;
    (wide ? high : low) = speed;
  }
  return low;
}

/// The speed for which a turn is laid out: given, or the largest in steps of 5 mm/s, or the least above the top speed.
inline double layout_speed(const Course& course, const Robot& robot) {
  if (course.turn == Turn::f180) return speed_around_post(course, robot);
  if (const double given = robot.layouts[static_cast<unsigned>(course.turn)].given; given > 0.0) return given;
  const double top = std::floor(top_speed(course, robot) / 5.0) * 5.0;
  for (double speed = top; speed > 0.0; speed -= 5.0)
    if (fits(course, speed, robot)) return speed;
  for (double speed = top + 5.0; speed < 10'000.0; speed += 5.0)
    if (fits(course, speed, robot)) return speed;
  return 0.0;
}

/// The straight before and after the curve around a post: given, or half a cell, or as many whole mm as the wall ahead
/// allows.
inline double lead_around_post(const Layout& layout, const Robot& robot) {
  if (const double given = robot.layouts[static_cast<unsigned>(Turn::f180)].given; given > 0.0) return given;
  double reach = 0.0;
  for (const Moment& moment : layout.moments) reach = std::max(reach, moment.place.y);
  const double room = 1.5 * robot.cell - robot.clearance - reach;
  return room < robot.cell / 2.0 ? std::floor(room) : robot.cell / 2.0;
}

inline Layout layout_of(const Course& course, const Robot& robot) {
  Layout layout = laid_out(course, layout_speed(course, robot), robot, fine);
  if (course.turn == Turn::f180) layout.before = layout.after = lead_around_post(layout, robot);
  return layout;
}

inline bool drives(const Robot& robot, const Course& course) {
  return robot.layouts[static_cast<unsigned>(course.turn)].driven &&
         (robot.diagonals || !(course.from_diagonal() || course.to_diagonal()));
}

/// The tables' turns of one kind.
inline std::vector<DrivenTurn> turns_of(const DriveTables& tables, Turn turn) {
  std::vector<DrivenTurn> turns;
  std::copy_if(tables.turns.begin(), tables.turns.end(), std::back_inserter(turns),
               [&](const DrivenTurn& driven) { return driven.turn == turn; });
  return turns;
}

inline double largest_speed(const std::vector<DrivenTurn>& turns) {
  double largest = 0.0;
  for (const DrivenTurn& turn : turns) largest = std::max(largest, turn.speed);
  return largest;
}

/// The leads of a turn in the tables, in the direction in which it leads onto a diagonal.
inline std::pair<double, double> leads_of(const DriveTables& tables, const Course& course, const DrivenTurn& turn) {
  const bool back = turn.turn != course.turn;
  const auto lead = [&](bool diagonal, std::size_t lane) {
    return (diagonal ? tables.diagonal : tables.along).lanes[lane].lead;
  };
  const double before = lead(course.from_diagonal(), back ? turn.to : turn.from);
  return {before, lead(course.to_diagonal(), back ? turn.from : turn.to)};
}

class TurnsInSteps : public testing::TestWithParam<Robot> {
 protected:
  TurnsInSteps() : model_(make_drive_model(robot())) {}
  void SetUp() override { ASSERT_EQ(model_.error, ""); }

  static const Robot& robot() { return GetParam(); }
  const DriveTables& tables() const { return model_.tables; }

  /// Calls check(layout, turn) for each turn of the tables, both ways, with the one that limits make of it.
  template <class Check>
  void for_each_turn(Check check) const {
    for (const Course& course : courses) {
      if (!drives(robot(), course)) continue;
      const Layout layout = layout_of(course, robot());
      for (const Turn turn : std::set{course.turn, course.back}) {
        SCOPED_TRACE(testing::Message() << name_of(turn) << " laid out for " << layout.speed << " mm/s");
        check(course, layout, turns_of(tables(), turn));
      }
    }
  }

  DriveModel model_;
};

}  // namespace labmouse::test
