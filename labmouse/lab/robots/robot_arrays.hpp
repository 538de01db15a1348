// The turns and straights of a robot as C arrays, for the firmware of a mouse.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// Names of turns in firmware, by Turn.
struct TurnNames {
  std::string_view name;  ///< of the convention
  std::array<std::string_view, all_turns.size()> of;
};

/// Those of labmouse, of UKMARS and of kerikun11, in this order.
std::span<const TurnNames> all_turn_names();

/// A header in C: for each turn its speeds, the fastest first, each with leads, curve, ramp and yaw rates; and the
/// limits on straights. Turns from a diagonal to an axis are those onto it, driven backwards. The robot must have
/// limits, not given times of its turns.
std::string robot_arrays(const Robot& robot, const DriveModel& model, const TurnNames& names);

}  // namespace labmouse
