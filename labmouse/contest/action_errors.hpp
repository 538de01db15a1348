// Counts, from a record, the steps that were not performed as the mouse asked. A mouse that does not notice them has a
// wrong position.
#pragma once

#include "labmouse/contest/record.hpp"
#include "labmouse/contest/rules.hpp"
#include "labmouse/grid/cell.hpp"
#include "labmouse/mouse/motion.hpp"

namespace labmouse {

/// Steps of one kind.
struct ActionErrorCount {
  int steps = 0;
  /// Number of the first such step, from 1; 0 if there is none.
  int first = 0;

  friend constexpr bool operator==(const ActionErrorCount&, const ActionErrorCount&) = default;
};

/// All kinds; one step can be of several.
struct ActionErrors {
  ActionErrorCount blocked;         ///< a wall ended the movement early
  ActionErrorCount void_rotations;  ///< a rotation other than -90, 0 and 90, which turns nothing
  ActionErrorCount cut_movements;   ///< a movement beyond the stride of the rules
  ActionErrorCount idle_resets;     ///< a reset before a goal was entered, or in the speed run

  friend constexpr bool operator==(const ActionErrors&, const ActionErrors&) = default;
};

/// Whether a step asks for a rotation that is not performed.
constexpr bool has_void_rotation(const Action& action) {
  return action.kind == Action::Kind::step && action.rotation != 0 &&
         rotated(Heading::north, action.rotation) == Heading::north;
}

/// Counts them over both runs of a complete record.
ActionErrors action_errors_of(const RunRecord& record, const Rules& rules);

/// The number of steps that ended early at a wall that the mouse knew: one of the border, or one that its readings had
/// shown as closed by then, that of the step included. Backing into a wall that it has not seen is none.
/// @param record complete, of a contest in a maze of that size.
int known_wall_hits(const RunRecord& record, Size size);

}  // namespace labmouse
