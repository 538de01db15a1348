// The curve of a turn, driven at one speed: the yaw rate rises, stays (an arc), and falls. How it rises is the robot's
// profile of turns: at a steady rate (a clothoid), or at one that rises and falls itself.
#pragma once

#include <vector>

#include "labmouse/mouse/robot/turn.hpp"
#include "labmouse/mouse/robot/yaw_ramp.hpp"

namespace labmouse {

/// A part of a curve of free shape. Its curvature is a polynomial of the distance from its beginning.
struct CurvePart {
  double length = 0.0;     ///< mm
  double curvature = 0.0;  ///< rad/mm to the left where it begins
  double growth = 0.0;     ///< rad/mm², of the curvature where it begins
  double bend = 0.0;       ///< rad/mm³, of the growth; constant
  PathPoint begin;         ///< as seen from the beginning of the curve

  /// The curvature at a point of it, rad/mm.
  /// @param distance mm from its beginning.
  double curvature_at(double distance) const { return curvature + distance * (growth + distance * bend / 2.0); }
  /// The growth of the curvature there, rad/mm².
  /// @param distance mm from its beginning.
  double growth_at(double distance) const { return growth + distance * bend; }
  /// A point of it, as seen from the beginning of the curve.
  /// @param distance mm from its beginning.
  PathPoint at(double distance) const;
};

/// A turn to the left from its first node to its last: a straight lead-in, the curve, a straight lead-out.
struct TurnShape {
  Turn turn = Turn::f45;
  double lead_in = 0.0;   ///< mm
  double lead_out = 0.0;  ///< mm
  double length = 0.0;    ///< mm of the curve alone
  RampPath ramp;          ///< the first part of the curve; the last is its mirror image
  /// Of a curve of free shape its parts in order, which replace the ramps; its `ramp` has the largest curvature only.
  std::vector<CurvePart> parts;
  PathPoint end;           ///< the last node, as seen from the first
  double clearance = 0.0;  ///< mm from the nearest post or wall that may stand there, middle to middle

  /// A point of the path.
  /// @param distance mm from the first node, 0 to whole().
  /// @return as seen from the first node.
  PathPoint at(double distance) const;
  /// Length of the path from node to node, in mm.
  double whole() const { return lead_in + length + lead_out; }
  /// The curvature of the path at a point.
  /// @param distance mm from the first node.
  /// @return rad/mm to the left; 0 on the leads.
  double curvature_at(double distance) const;
  /// The growth of the curvature at a point of the curve.
  /// @param driven mm from the beginning of the curve, 0 to `length`.
  /// @return rad/mm²
  double growth_at(double driven) const;
};

/// Joins parts to one curve: sets where each of them begins.
/// @param parts in order; all but `begin` is given.
/// @return the end of the last one, as seen from the beginning of the first.
PathPoint join(std::vector<CurvePart>& parts);

/// Puts the curve of a shape between the nodes of its turn: sets `end` and both leads. Around a post both leads are
/// half a cell.
/// @param shape with its turn, its length, and its ramp or its parts.
/// @param cell side of a cell, mm.
/// @return a lead is below 0 if the curve needs more room than there is.
TurnShape placed(TurnShape shape, double cell);

/// The last node of a turn.
/// @param turn to the left.
/// @param cell side of a cell, mm.
/// @return as seen from the first node.
PathPoint end_of(Turn turn, double cell);

/// The tightest curve at a speed within the limits.
/// @param turn its nodes.
/// @param speed mm/s, greater than 0.
/// @param limits lateral and yaw acceleration must be greater than 0.
/// @param cell side of a cell, mm.
/// @return a lead is below 0 if the curve needs more room than there is. The curve of a 180 may end beside its last
///   node: width_of() gives its width. Clearance is left at 0.
TurnShape shape_at(Turn turn, double speed, const CurveLimits& limits, double cell);
/// The width of the curve alone, from its beginning across to its end.
/// @param shape its leads do not count.
/// @return mm to the left, as seen in the direction of its beginning.
double width_of(const TurnShape& shape);

/// A curve eight times as long as each of its clothoids, as wide as the nodes allow.
/// @param turn its nodes.
/// @param cell side of a cell, mm.
/// @return with leads of 0 or more. Clearance is left at 0.
TurnShape plain_shape(Turn turn, double cell);

/// The same path driven backwards, mirrored so that it turns to the left again.
/// @param shape any.
/// @return leads are exchanged; the turn is reversed().
TurnShape backwards(const TurnShape& shape);

}  // namespace labmouse
