#include "labmouse/lab/drawing/route_line.hpp"

#include <span>

namespace labmouse::drawing {
namespace {

Point towards(Point from, Heading heading, int distance) {
  const Cell unit = neighbour({0, 0}, heading);
  return from.moved(unit.x * distance, -unit.y * distance);
}

/// A part of the walk during which the mouse is not carried.
class Stroke {
 public:
  Stroke(const Frame& frame, std::span<const Leg> legs, int lane) : frame_(frame), legs_(legs), lane_(lane) {}

  void append_to(RouteLine& line) const {
    std::vector<Point> points;
    const auto add = [&](Point point) {
      if (points.empty() || points.back() != point) points.push_back(point);
    };
    for (std::size_t step = 0; step <= legs_.size(); ++step) {
      const auto in = before(step);
      const auto out = after(step);
      const Cell cell = step == 0 ? legs_.front().from : legs_[step - 1].to;
      const bool about = in && out && *out == opposite(*in);
      const Point stop = spot(cell, in, about ? in : out);
      add(stop);
      if (about) add(spot(cell, out, out));
      if (step > 0) line.stops.push_back(stop);
    }
    line.strokes.push_back(points);
  }

 private:
  /// The direction of the last movement up to the end of a step, and of the first one after it.
  std::optional<Heading> before(std::size_t step) const {
    while (step > 0 && !legs_[step - 1].direction) --step;
    return step > 0 ? legs_[step - 1].direction : std::nullopt;
  }
  std::optional<Heading> after(std::size_t step) const {
    while (step < legs_.size() && !legs_[step].direction) ++step;
    return step < legs_.size() ? legs_[step].direction : std::nullopt;
  }

  /// The point at which a line that enters and leaves a cell in these directions passes it: on the right of both.
  Point spot(Cell cell, std::optional<Heading> in, std::optional<Heading> out) const {
    Point point = frame_.centre(cell);
    if (in) point = towards(point, right_of(*in), lane_);
    if (out && out != in) point = towards(point, right_of(*out), lane_);
    return point;
  }

  const Frame& frame_;
  std::span<const Leg> legs_;
  int lane_;
};

}  // namespace

RouteLine route_line(const Frame& frame, const std::vector<Leg>& legs, int lane) {
  RouteLine line;
  for (std::size_t first = 0; first < legs.size();) {
    if (legs[first].carried()) {
      line.stops.push_back(frame.centre(legs[first].to));
      ++first;
      continue;
    }
    std::size_t last = first;
    while (last < legs.size() && !legs[last].carried()) ++last;
    Stroke(frame, std::span(legs).subspan(first, last - first), lane).append_to(line);
    first = last;
  }
  return line;
}

}  // namespace labmouse::drawing
