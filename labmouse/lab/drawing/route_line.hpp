// The line of a walk in an SVG picture.
#pragma once

#include <vector>

#include "labmouse/lab/drawing/frame.hpp"
#include "labmouse/lab/drawing/legs.hpp"

namespace labmouse::drawing {

struct RouteLine {
  /// Polylines; a new one begins after the mouse was carried.
  std::vector<std::vector<Point>> strokes;
  /// Where each step ends, in order.
  std::vector<Point> stops;
};

/// The line through the legs. It is `lane` pixels right of the way, as traffic is, so that ways there and back do not
/// overlap; 0 draws it in the middle.
RouteLine route_line(const Frame& frame, const std::vector<Leg>& legs, int lane);

}  // namespace labmouse::drawing
