#include "labmouse/lab/robots/robot_keys.hpp"

#include <fmt/format.h>

#include <array>

namespace labmouse {
namespace {

using With = RobotKey::With;

constexpr bool optional = false;

constexpr std::array keys = {
    RobotKey{"cell", "mm", 20.0, 1000.0},
    RobotKey{"clearance", "mm", 0.0, 500.0, With::curves},
    RobotKey{"run_up", "mm", 0.0, 500.0, With::curves, optional},
    RobotKey{"sight", "cells", 1.0, 32.0, With::always, optional, true},
    RobotKey{"straight.speed", "mm/s", 100.0, 20'000.0},
    RobotKey{"straight.acceleration", "mm/s²", 100.0, 200'000.0},
    RobotKey{"straight.braking", "mm/s²", 100.0, 200'000.0, With::always, optional},
    RobotKey{"diagonal.speed", "mm/s", 100.0, 20'000.0, With::always, optional},
    RobotKey{"diagonal.acceleration", "mm/s²", 100.0, 200'000.0, With::always, optional},
    RobotKey{"diagonal.braking", "mm/s²", 100.0, 200'000.0, With::always, optional},
    RobotKey{"curve.lateral_acceleration", "mm/s²", 100.0, 200'000.0, With::curves},
    RobotKey{"curve.yaw_acceleration", "rad/s²", 1.0, 100'000.0, With::curves},
    RobotKey{"turns.speed", "mm/s", 100.0, 20'000.0, With::turns},
    RobotKey{"turns.45", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"turns.90", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"turns.135", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"turns.180", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"turns.V90", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"turns.S90", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"search.speed", "mm/s", 10.0, 20'000.0, With::search_speed},
    RobotKey{"search.pivot_speed", "rad/s", 0.1, 100.0, With::search_speed},
    RobotKey{"search.pivot_acceleration", "rad/s²", 1.0, 100'000.0, With::search_speed},
    RobotKey{"search.cell", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.turn", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.back", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.quarter", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.half_cell", "ms", 1.0, 60'000.0, With::search_times},
};

}  // namespace

std::span<const RobotKey> robot_keys() { return keys; }

std::string range_of(const RobotKey& key) {
  return fmt::format("{}{:g} to {:g} {}", key.whole ? "a whole number, " : "", key.low, key.high, key.unit);
}

std::string hint_of(const RobotKey& key, double value) {
  const std::string_view unit = key.unit;
  const bool thousandths = unit.starts_with("mm") || unit == "ms";
  if (!thousandths || !(value * 1e3 >= key.low && value * 1e3 <= key.high)) return "";
  return fmt::format("; if the value is in {}, write {:g}", unit.substr(1), value * 1e3);
}

bool RobotForms::has(const RobotKey& key) const {
  switch (key.with) {
    case With::curves:
      return !turns;
    case With::turns:
      return turns;
    case With::search_speed:
      return !search_times;
    case With::search_times:
      return search_times;
    default:
      return true;
  }
}

std::string_view why_not(const RobotKey& key, const RobotForms& forms) {
  if (key.with == With::curves) return "has no effect together with [turns], which gives the times of all turns";
  return forms.search_times ? "has no effect together with 'search.cell', which begins a table of times"
                            : "belongs to a table of times, which also needs 'search.cell'";
}

}  // namespace labmouse
