#include "labmouse/mouse/robot/free_turn.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "labmouse/functions/angles.hpp"
#include "labmouse/functions/position.hpp"
#include "labmouse/mouse/robot/straights.hpp"
#include "labmouse/mouse/robot/turn_drive.hpp"
#include "labmouse/mouse/robot/turn_room.hpp"

namespace labmouse {
namespace {

/// What the search varies: the speed at the apex in mm/s; and for both ends of a turn the bend to the other side in
/// rad, the straight between it and the turn in mm, and which share of the yaw acceleration its ramp takes at that
/// speed.
struct Form {
  double apex = 0.0;
  std::array<double, 2> swing = {0.0, 0.0};
  std::array<double, 2> between = {0.0, 0.0};
  std::array<double, 2> ease = {1.0, 1.0};
};

void append(std::vector<CurvePart>& parts, const std::vector<CurvePart>& more) {
  for (const CurvePart& part : more)
    if (part.length > 1e-9) parts.push_back(part);
}

/// The parts of a ramp from a straight to the largest curvature.
std::vector<CurvePart> rising(const RampPath& ramp) {
  const double growth = ramp.peak / (ramp.length - ramp.onset);
  if (ramp.onset <= 0.0) return {{ramp.length, 0.0, growth, 0.0, {}}};
  const double bend = growth / ramp.onset, first = growth * ramp.onset / 2.0;
  const double steady = std::max(0.0, ramp.length - 2.0 * ramp.onset);
  return {{ramp.onset, 0.0, 0.0, bend, {}},
          {steady, first, growth, 0.0, {}},
          {ramp.onset, first + steady * growth, growth, -bend, {}}};
}
std::vector<CurvePart> rising(const YawRamp& ramp, double speed) {
  return rising({speed * ramp.seconds, speed * ramp.onset, ramp.rate / speed, TurnProfile::trapezoid});
}

/// In two parts, because CurvePart::at() is exact up to half a circle.
std::vector<CurvePart> arc(double length, double curvature) {
  return {{length / 2.0, curvature, 0.0, 0.0, {}}, {length / 2.0, curvature, 0.0, 0.0, {}}};
}

std::vector<CurvePart> mirrored(std::vector<CurvePart> parts) {
  std::reverse(parts.begin(), parts.end());
  for (CurvePart& part : parts) {
    part.curvature = part.curvature_at(part.length);
    part.growth = -part.growth_at(part.length);
  }
  return parts;
}

CurveLimits eased(CurveLimits limits, double ease) {
  limits.yaw_acceleration *= ease;
  return limits;
}

/// Adds a bend at one speed: a ramp, an arc, a ramp.
void add_bend(std::vector<CurvePart>& parts, double angle, double side, double speed, const CurveLimits& limits,
              const std::array<double, 2>& ease) {
  if (angle <= 0.0) return;
  double rate = limits.lateral_acceleration / speed;
  if (limits.yaw_speed > 0.0) rate = std::min(rate, limits.yaw_speed);
  const CurveLimits first = eased(limits, ease[0]), last = eased(limits, ease[1]);
  YawRamp in = ramp_to(rate, first), out = ramp_to(rate, last);
  if (rate * (in.seconds + out.seconds) / 2.0 > angle) {
    if (limits.yaw_jerk > 0.0) {
      in = out = ramp_of_half(angle, limits);
    } else {
      rate = std::sqrt(2.0 * angle / (1.0 / first.yaw_acceleration + 1.0 / last.yaw_acceleration));
      in = ramp_to(rate, first), out = ramp_to(rate, last);
    }
    rate = in.rate;
  }
  const double even = std::max(0.0, angle - rate * (in.seconds + out.seconds) / 2.0), peak = rate / speed;
  std::vector<CurvePart> bend;
  append(bend, rising(in, speed));
  append(bend, arc(even / peak, peak));
  append(bend, mirrored(rising(out, speed)));
  for (CurvePart& part : bend) {
    part.curvature *= side;
    part.growth *= side;
    part.bend *= side;
  }
  append(parts, bend);
}

/// The path of a trapezoid, in parts.
TurnShape in_parts(TurnShape shape) {
  append(shape.parts, rising(shape.ramp));
  append(shape.parts, arc(shape.length - 2.0 * shape.ramp.length, shape.ramp.peak));
  append(shape.parts, mirrored(rising(shape.ramp)));
  join(shape.parts);
  return shape;
}

/// The search for one turn of one robot.
class Search {
 public:
  Search(const FittedTurn& plain, const Robot& robot, double top)
      : robot_(robot), limits_(curve_limits(robot)), top_(top), turn_(plain.shape.turn), best_(plain) {
    const TurnRoom room = room_of(turn_);
    from_ = room.from;
    // Walls farther away than this from the middle of the path are out of reach.
    const MazePoint middle = point(plain.shape.at(plain.shape.whole() / 2.0));
    for (const Wall& wall : room.standing)
      if (distance(middle, wall) < 1.6) walls_.push_back(wall);
    best_.shape = in_parts(plain.shape);
    best_.speed = slowest_ = speed_on(best_.shape, plain.speed);
    cost_ = cost_of(best_, robot_);
    form_.apex = std::sqrt(robot.lateral_acceleration / best_.shape.ramp.peak);
    if (robot.yaw_speed > 0.0) form_.apex = std::min(form_.apex, robot.yaw_speed / best_.shape.ramp.peak);
  }

  FittedTurn best() {
    try_form(form_);
    constexpr int steps = 6;
    for (int i = 0; i < steps; ++i)
      for (bool better = true; better;) {
        better = false;
        for (const Form& next : neighbours(1.0 / (1 << i))) better |= try_form(next);
      }
    best_.shape.clearance = clearance_of(best_.shape, robot_.cell);
    return best_;
  }

 private:
  static constexpr double places = 80.0;  ///< along a curve, at which its clearance is tested

  MazePoint point(const PathPoint& place) const { return maze_point(from_, true, place, robot_.cell); }

  bool symmetric() const {
    return turn_ == Turn::f90 || turn_ == Turn::f180 || turn_ == Turn::v90 || turn_ == Turn::s90;
  }

  std::vector<Form> neighbours(double step) const {
    std::vector<Form> all;
    const auto add = [&](auto change) {
      for (const double sign : {1.0, -1.0})
        for (int ends = symmetric() ? 3 : 1; ends <= 3; ++ends) {
          Form next = form_;
          for (std::size_t end = 0; end < 2; ++end)
            if (ends >> end & 1) change(next, end, sign * step);
          all.push_back(next);
        }
    };
    add([](Form& form, std::size_t end, double by) { form.swing[end] = std::max(0.0, form.swing[end] + 0.2 * by); });
    add([&](Form& form, std::size_t end, double by) {
      form.between[end] = std::max(0.0, form.between[end] + robot_.cell / 8.0 * by);
    });
    if (robot_.grip > 0.0)
      add([](Form& form, std::size_t end, double by) {
        form.ease[end] = std::clamp(form.ease[end] + 0.25 * by, 0.05, 1.0);
      });
    for (const double sign : {1.0, -1.0}) {
      Form next = form_;
      next.apex *= 1.0 + 0.1 * sign * step;
      all.push_back(next);
    }
    return all;
  }

  TurnShape curve_of(const Form& form) const {
    const double speed = form.apex;
    TurnShape shape;
    shape.turn = turn_;
    const double main = eighths(turn_) * (pi / 4.0) + form.swing[0] + form.swing[1];
    for (std::size_t end = 0; end < 2; ++end) {
      if (end == 1) add_bend(shape.parts, main, 1.0, speed, limits_, form.ease);
      if (form.swing[end] <= 0.0) continue;
      const std::vector<CurvePart> straight = {{form.between[end], 0.0, 0.0, 0.0, {}}};
      if (end == 1) append(shape.parts, straight);
      add_bend(shape.parts, form.swing[end], -1.0, speed, limits_, {1.0, 1.0});
      if (end == 0) append(shape.parts, straight);
    }
    for (const CurvePart& part : shape.parts) {
      shape.length += part.length;
      shape.ramp.peak = std::max(shape.ramp.peak, std::abs(part.curvature));
    }
    join(shape.parts);
    return placed(std::move(shape), robot_.cell);
  }

  bool clear(const Position& place, double least) const {
    const MazePoint here = point({place.x, place.y, 0.0});
    return std::none_of(walls_.begin(), walls_.end(), [&](const Wall& wall) { return distance(here, wall) < least; });
  }

  /// The clearance at the places of a path, in mm, that keeps the robot's clearance between them: there a post is
  /// nearer by at most step² / 8 times the path's curvature and that of a circle around the post.
  double least_clearance(const TurnShape& shape) const {
    const double step = shape.length / places;
    return robot_.clearance + step * step / 8.0 * (shape.ramp.peak + 1.0 / std::max(1.0, robot_.clearance));
  }

  /// Whether the curve keeps the clearance, by small steps that are taken for arcs.
  bool clear(const TurnShape& shape) const {
    Position place{shape.lead_in, 0.0};
    Direction ahead;
    const double most = shape.length / places;
    const double least = least_clearance(shape) / robot_.cell;
    for (const CurvePart& part : shape.parts) {
      const int steps = static_cast<int>(part.length / most) + 1;
      const double step = part.length / steps;
      for (int i = 0; i < steps; ++i) {
        const double half = part.curvature_at(step * (i + 0.5)) * step / 2.0;
        const Direction chord = turned_by(ahead, half);
        const double length = step * (1.0 - half * half / 6.0);
        place = {place.x + length * chord.cosine, place.y + length * chord.sine};
        if (!clear(place, least)) return false;
        ahead = turned_by(chord, half);
      }
    }
    return true;
  }

  /// The path of a form, if it fits.
  std::optional<TurnShape> fitting(const Form& form) const {
    TurnShape shape = curve_of(form);
    if (shape.lead_in < 0.0 || shape.lead_out < 0.0 || !clear(shape)) return std::nullopt;
    return shape;
  }

  /// The path of a 180, if it fits: as wide as a cell, with the shortest leads that keep the clearance. Sets the apex.
  std::optional<TurnShape> around_post(Form& form) const {
    const auto excess = [&](double apex) {
      form.apex = apex;
      return width_of(curve_of(form)) - robot_.cell;
    };
    double before = form.apex * 0.99, apex = form.apex, excess_before = excess(before);
    for (int i = 0; i < 8; ++i) {
      const double here = excess(apex);
      if (here == excess_before) break;
      const double next = std::clamp(apex - here * (apex - before) / (here - excess_before), apex / 2.0, apex * 2.0);
      before = apex, excess_before = here, apex = next;
    }
    form.apex = apex;
    TurnShape shape = curve_of(form);
    if (std::abs(width_of(shape) - robot_.cell) > 1e-9) return std::nullopt;
    const double reach = shape.at(shape.lead_in + shape.length / 2.0).ahead - shape.lead_in;
    const double most = 1.5 * robot_.cell - least_clearance(shape) - reach;
    const auto with = [&](double lead) {
      shape.lead_in = shape.lead_out = lead;
      return clear(shape);
    };
    if (most < 0.0 || !with(most)) return std::nullopt;
    double close = 0.0, wide = most;
    for (int i = 0; i < 12; ++i) {
      const double middle = (close + wide) / 2.0;
      (with(middle) ? wide : close) = middle;
    }
    shape.lead_in = shape.lead_out = wide;
    return shape;
  }

  double speed_on(const TurnShape& shape, double apex) const {
    return robot_.grip > 0.0 ? end_speed_of(shape, top_, robot_) : std::min(apex, top_);
  }

  bool take(const Form& form, const TurnShape& shape) {
    const FittedTurn found{shape, speed_on(shape, form.apex), {}};
    if (found.speed < slowest_ * (1.0 - 1e-9)) return false;
    const double cost = cost_of(found, robot_);
    if (cost > cost_ - 1e-7) return false;
    best_ = found, cost_ = cost, form_ = form;
    return true;
  }

  /// Tries a form, and the same one with the fastest apex that fits.
  bool try_form(Form form) {
    if (turn_ == Turn::f180) {
      const auto shape = around_post(form);
      return shape && take(form, *shape);
    }
    std::optional<TurnShape> shape = fitting(form);
    if (!shape) {
      form.apex *= 0.96;
      shape = fitting(form);
      if (!shape) return false;
    }
    const bool better = take(form, *shape);
    Form fastest = form;
    double low = form.apex, high = form.apex * 1.08;
    for (int i = 0; i < 7; ++i) {
      fastest.apex = (low + high) / 2.0;
      if (auto faster = fitting(fastest))
        shape = std::move(faster), low = fastest.apex;
      else
        high = fastest.apex;
    }
    fastest.apex = low;
    return take(fastest, *shape) || better;
  }

  const Robot& robot_;
  CurveLimits limits_;
  double top_;
  Turn turn_;
  DriveNode from_;
  std::vector<Wall> walls_;
  FittedTurn best_;
  double slowest_ = 0.0;  ///< mm/s, of the plain path
  double cost_ = 0.0;
  Form form_;
};

/// Cells of straight on either side of a turn, from its node on, over which its cost counts.
constexpr double straight_cells = 1.0;

/// Seconds of a lead and the straight behind it, between the end of a curve and the middle of a straight between two
/// such turns.
double straight_seconds(double lead, double speed, bool diagonal, const Robot& robot) {
  const StraightLimits limits = diagonal ? limits_diagonal(robot) : limits_along(robot);
  return *seconds_between(2.0 * (lead + straight_cells * robot.cell), speed, speed, limits) / 2.0;
}

}  // namespace

double cost_of(const TurnShape& shape, double from, double to, double seconds, const Robot& robot) {
  return seconds + straight_seconds(shape.lead_in, from, begins_diagonal(shape.turn), robot) +
         straight_seconds(shape.lead_out, to, ends_diagonal(shape.turn), robot);
}

double cost_of(const FittedTurn& turn, const Robot& robot) {
  double seconds = turn.shape.length / turn.speed;
  if (robot.grip > 0.0) {
    const auto drive = turn_drive(turn.shape, turn.speed, turn.speed, turn_top_speed(turn.shape.turn, robot), robot);
    if (!drive) return 1e9;
    seconds = drive->seconds;
  }
  return cost_of(turn.shape, turn.speed, turn.speed, seconds, robot);
}

void share_leads(std::vector<FittedTurn>& paths) {
  double lead_in = paths.front().shape.lead_in, lead_out = paths.front().shape.lead_out;
  for (const FittedTurn& path : paths) {
    lead_in = std::min(lead_in, path.shape.lead_in);
    lead_out = std::min(lead_out, path.shape.lead_out);
  }
  for (FittedTurn& path : paths) {
    TurnShape& shape = path.shape;
    std::vector<CurvePart> parts;
    append(parts, {{shape.lead_in - lead_in, 0.0, 0.0, 0.0, {}}});
    append(parts, shape.parts);
    append(parts, {{shape.lead_out - lead_out, 0.0, 0.0, 0.0, {}}});
    shape.length += shape.lead_in - lead_in + shape.lead_out - lead_out;
    shape.parts = std::move(parts);
    join(shape.parts);
    shape.lead_in = lead_in, shape.lead_out = lead_out;
  }
}

FittedTurn freed(const FittedTurn& plain, double top, const Robot& robot) { return Search(plain, robot, top).best(); }

}  // namespace labmouse
