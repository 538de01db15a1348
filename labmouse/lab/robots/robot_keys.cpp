#include "labmouse/lab/robots/robot_keys.hpp"

#include <fmt/format.h>

#include <array>

#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {
namespace {

using With = RobotKey::With;
using Kind = RobotKey::Kind;

constexpr bool needed = true, optional = false, of_diagonals = true;

/// The speed that the path of a turn is laid out for.
constexpr RobotKey layout(std::string_view name, bool diagonal) {
  return {name, "mm/s", 10.0, 20'000.0, With::curves, optional, Kind::number_or_false, diagonal};
}
/// The time of a turn.
constexpr RobotKey turn(std::string_view name, bool diagonal) {
  return {name, "ms", 1.0, 10'000.0, With::turns, needed, Kind::number_or_false, diagonal};
}
constexpr RobotKey diagonal(std::string_view name, std::string_view unit, double low, double high) {
  return {name, unit, low, high, With::always, optional, Kind::number, of_diagonals};
}

constexpr std::array keys = {
    RobotKey{"cell", "mm", 20.0, 1000.0},
    RobotKey{"clearance", "mm", 0.0, 500.0, With::curves},
    RobotKey{"run_up", "mm", 0.0, 500.0, With::curves, optional},
    RobotKey{"sight", "cells", 1.0, 32.0, With::always, optional, Kind::whole},
    RobotKey{"diagonals", "", 0.0, 1.0, With::always, optional, Kind::yes_or_no},
    RobotKey{"stop", "", 0.0, 0.0, With::curves, optional, Kind::end},
    RobotKey{"straight.speed", "mm/s", 50.0, 20'000.0},
    RobotKey{"straight.acceleration", "mm/s²", 100.0, 200'000.0},
    RobotKey{"straight.braking", "mm/s²", 100.0, 200'000.0, With::always, optional},
    diagonal("diagonal.speed", "mm/s", 50.0, 20'000.0),
    diagonal("diagonal.acceleration", "mm/s²", 100.0, 200'000.0),
    diagonal("diagonal.braking", "mm/s²", 100.0, 200'000.0),
    RobotKey{"curve.lateral_acceleration", "mm/s²", 100.0, 200'000.0, With::curves},
    RobotKey{"curve.yaw_acceleration", "rad/s²", 1.0, 100'000.0, With::curves},
    RobotKey{"curve.yaw_speed", "rad/s", 0.1, 100.0, With::curves, optional},
    RobotKey{"curve.yaw_jerk", "rad/s³", 10.0, 1e8, With::curves, optional},
    RobotKey{"curve.grip", "mm/s²", 100.0, 200'000.0, With::curves, optional},
    RobotKey{"curve.speeds", "speeds", 1.0, most_speeds, With::curves, optional, Kind::whole},
    layout("layout.45", of_diagonals),
    layout("layout.90", false),
    layout("layout.135", of_diagonals),
    RobotKey{"layout.180", "mm", 0.1, 500.0, With::curves, optional, Kind::number_or_false},
    layout("layout.V90", of_diagonals),
    RobotKey{"layout.S90", "mm/s", 10.0, 20'000.0, With::curves, optional},
    RobotKey{"turns.speed", "mm/s", 50.0, 20'000.0, With::turns},
    turn("turns.45", of_diagonals),
    turn("turns.90", false),
    turn("turns.135", of_diagonals),
    turn("turns.180", false),
    turn("turns.V90", of_diagonals),
    RobotKey{"turns.S90", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"search.speed", "mm/s", 10.0, 20'000.0, With::search_speed},
    RobotKey{"search.turn_speed", "mm/s", 10.0, 20'000.0, With::search_speed, optional},
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
  if (key.kind == Kind::yes_or_no) return "true or false";
  if (key.kind == Kind::end) return R"("goal" or "beyond")";
  return fmt::format("{}{:.10g} to {:.10g} {}{}", key.kind == Kind::whole ? "a whole number, " : "", key.low, key.high,
                     key.unit, key.kind == Kind::number_or_false ? ", or false" : "");
}

std::string hint_of(const RobotKey& key, double value) {
  const std::string_view unit = key.unit;
  constexpr double degree = 3.141592653589793 / 180.0;
  if (unit.starts_with("rad") && value > key.high && value * degree <= key.high)
    return fmt::format("; if the value is in degrees{}, write {:.4g}", unit.substr(3), value * degree);
  const bool thousandths = unit.starts_with("mm") || unit == "ms";
  if (!thousandths || !(value * 1e3 >= key.low && value * 1e3 <= key.high)) return "";
  return fmt::format("; if the value is in {}, write {:g}", unit.substr(1), value * 1e3);
}

bool RobotForms::has(const RobotKey& key) const {
  if (key.of_diagonals && !diagonals) return false;
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
  if (key.of_diagonals && !forms.diagonals) return "has no effect on a robot without diagonals";
  if (key.with == With::curves) return "has no effect together with [turns], which gives the times of all turns";
  return forms.search_times ? "has no effect together with 'search.cell', which begins a table of times"
                            : "belongs to a table of times, which also needs 'search.cell'";
}

}  // namespace labmouse
