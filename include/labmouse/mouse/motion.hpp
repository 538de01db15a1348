// Which moves exist and what they cost.
//
// One decision turns the mouse by a quarter or not at all and then moves it straight, forward or back. So from every
// heading all four directions are one move away, and a cell alone is the state of a route:
//
//                 ^  (0, k)
//      (-90, k) <-+-> (90, k)      k = 1 .. longest
//                 v  (0, -k)
#pragma once

#include <array>
#include <cassert>
#include <cstdint>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

/// A table of moves: a straight run of k cells costs cost[k], for k from 1 to longest. The unit depends on the world
/// (steps in the world of steps). Costs are 1 to max_cost and do not fall as k grows.
struct Motion {
  static constexpr int max_longest = 8;
  static constexpr int max_cost = 63;

  int longest = 1;                                   ///< cells, 1 to max_longest
  std::array<std::uint8_t, max_longest + 1> cost{};  ///< by number of cells; cost[0] is 0

  friend constexpr bool operator==(const Motion&, const Motion&) = default;

  /// Whether the costs are as above.
  constexpr bool valid() const {
    if (longest < 1 || longest > max_longest) return false;
    for (unsigned k = 1; k <= static_cast<unsigned>(longest); ++k)
      if (cost[k] < 1 || cost[k] > max_cost || cost[k] < cost[k - 1]) return false;
    return true;
  }
  /// Whether every move costs one. The table must be valid.
  constexpr bool uniform() const { return cost[static_cast<unsigned>(longest)] == 1; }
};

/// The moves in the world of steps: all of them cost one step.
/// @param longest most cells in one step, 1 to Motion::max_longest; strides(1) is one cell at a time.
constexpr Motion strides(int longest = 3) {
  Motion motion;
  motion.longest = longest;
  for (unsigned k = 1; k <= static_cast<unsigned>(longest); ++k) motion.cost[k] = 1;
  assert(motion.valid());
  return motion;
}

/// The step that moves in a direction of the maze: forward, after a quarter turn, or backwards.
/// @param heading that of the mouse before the step.
/// @param direction where to move.
/// @param cells how many, 0 or more.
/// @return a step; its movement is negative where the mouse moves backwards.
constexpr Action move_in(Heading heading, Heading direction, int cells) {
  switch (quarters_between(heading, direction)) {
    case 0:
      return Action::step(0, cells);
    case 1:
      return Action::step(90, cells);
    case 2:
      return Action::step(0, -cells);
    default:
      return Action::step(-90, cells);
  }
}

/// The heading after the rotation of a step in the world of steps.
/// @param heading that before it.
/// @param degrees clockwise; values other than -90, 0 and 90 turn nothing.
constexpr Heading rotated(Heading heading, int degrees) {
  return degrees == 90 ? right_of(heading) : degrees == -90 ? left_of(heading) : heading;
}

/// The pose after a step in the world of steps.
/// @param pose that before it.
/// @param step one whose whole movement is known to be free: no wall stops it, and it is not cut.
/// @return outside the maze, if the movement leads there.
constexpr Pose after(Pose pose, const Action& step) {
  const Heading heading = rotated(pose.heading, step.rotation);
  return {neighbour(pose.cell, heading, step.movement), heading};
}

}  // namespace labmouse
