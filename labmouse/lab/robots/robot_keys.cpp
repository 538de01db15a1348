#include "labmouse/lab/robots/robot_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "labmouse/lab/robots/hardware_keys.hpp"
#include "labmouse/mouse/robot/robot.hpp"

namespace labmouse {
namespace {

using With = RobotKey::With;
using KeyKind = RobotKey::Kind;

constexpr bool needed = true, optional = false, of_diagonals = true;

constexpr std::array<std::string_view, 2> ends = {"goal", "beyond"};

constexpr std::string_view layout_meaning =
    "the speed for which the path of this turn is laid out, for published paths; default: the largest that fits. false "
    "for a turn that is not driven";
constexpr std::string_view turn_meaning = "the whole turn, from node to node; false for a turn that is not driven";

/// A key with the design speed of a turn's path.
constexpr RobotKey layout(std::string_view name, bool diagonal) {
  return {name, layout_meaning, "mm/s", 10.0, 20'000.0, With::curves, optional, KeyKind::number_or_false, diagonal};
}
/// A key with the time of a turn.
constexpr RobotKey turn(std::string_view name, bool diagonal) {
  return {name, turn_meaning, "ms", 1.0, 10'000.0, With::turns, needed, KeyKind::number_or_false, diagonal};
}
constexpr RobotKey diagonal(std::string_view name, std::string_view meaning, std::string_view unit, double low,
                            double high) {
  return {name, meaning, unit, low, high, With::always, optional, KeyKind::number, of_diagonals};
}

/// A key with a text, one of some.
constexpr RobotKey choice(std::string_view name, std::string_view meaning, std::span<const std::string_view> choices) {
  RobotKey key{name, meaning, "", 0.0, 0.0, With::curves, optional, KeyKind::choice};
  key.choices = choices;
  return key;
}

constexpr std::array limit_keys = {
    RobotKey{"cell", "side of a cell, from the middle of a wall to the middle of the next", "mm", 20.0, 1000.0},
    RobotKey{"clearance",
             "the distance that the middle of the robot keeps in turns from the middle of posts and walls: half its "
             "width, half the diagonal of a post (whose corners stand out: 8.5 mm where walls are 12 mm thick), and a "
             "safety margin. On a diagonal, posts are 0.354 cells away, so it cannot be more than that",
             "mm", 0.0, 500.0, With::curves},
    RobotKey{"run_up", "how far behind the middle of the start cell a run begins, less than half a cell; default 0",
             "mm", 0.0, 500.0, With::curves, optional},
    RobotKey{"sight", "how far its sensors see walls in each direction; default 1", "cells", 1.0, 32.0, With::always,
             optional, KeyKind::whole},
    RobotKey{"diagonals", "whether it drives diagonals; default true", "", 0.0, 1.0, With::always, optional,
             KeyKind::yes_or_no},
    choice("stop",
           "where a run may end: slow enough to stop in the last open cell straight behind the goal (\"goal\"), or "
           "at any speed (\"beyond\"); default \"goal\"",
           ends),
    RobotKey{"straight.speed", "top speed on straights", "mm/s", 50.0, 20'000.0},
    RobotKey{"straight.acceleration", "how quickly it gains speed on straights", "mm/s²", 100.0, 200'000.0},
    RobotKey{"straight.braking",
             "how quickly it loses speed on straights, as a positive number; default: the acceleration", "mm/s²", 100.0,
             200'000.0, With::always, optional},
    diagonal("diagonal.speed", "top speed on diagonals; default: that of straights", "mm/s", 50.0, 20'000.0),
    diagonal("diagonal.acceleration", "how quickly it gains speed on diagonals; default: as on straights", "mm/s²",
             100.0, 200'000.0),
    diagonal("diagonal.braking",
             "how quickly it loses speed on diagonals; default: the acceleration of diagonals if that is given, or "
             "else as on straights",
             "mm/s²", 100.0, 200'000.0),
    RobotKey{"curve.lateral_acceleration", "what the tyres can hold in curves: 9810 is one g", "mm/s²", 100.0,
             200'000.0, With::curves},
    RobotKey{"curve.yaw_acceleration", "how quickly a curve begins and ends", "rad/s²", 1.0, 100'000.0, With::curves},
    RobotKey{"curve.yaw_speed", "how quickly it turns at most; default: as quickly as the tyres hold", "rad/s", 0.1,
             100.0, With::curves, optional},
    RobotKey{"curve.yaw_jerk", "how quickly the yaw acceleration rises and falls; default: at once", "rad/s³", 10.0,
             1e8, With::curves, optional},
    choice(
        "curve.profile",
        "how the yaw rate rises at the beginning of a turn and falls at its end: at a steady yaw acceleration "
        "(\"trapezoid\"), as half a cosine wave (\"sine\"), or as a cubic polynomial (\"cubic\"); the largest yaw "
        "acceleration is that of curve.yaw_acceleration. Or the fastest path that is found for each turn (\"free\"), "
        "which gains most together with curve.grip. Default \"trapezoid\"",
        turn_profile_names),
    RobotKey{"curve.grip",
             "what the tyres hold in any direction, at least as much as every other acceleration; default: turns are "
             "driven at one speed each. Not together with a yaw jerk",
             "mm/s²", 100.0, 200'000.0, With::curves, optional},
    RobotKey{"curve.speeds", "of each turn at most; default 6", "speeds", 1.0, most_speeds, With::curves, optional,
             KeyKind::whole},
    layout("layout.45", of_diagonals),
    layout("layout.90", false),
    layout("layout.135", of_diagonals),
    RobotKey{"layout.180",
             "the straight before and after this turn; default: half a cell, or what the wall ahead allows. false for "
             "a turn that is not driven",
             "mm", 0.1, 500.0, With::curves, optional, KeyKind::number_or_false},
    layout("layout.V90", of_diagonals),
    RobotKey{
        "layout.S90",
        "the speed for which the path of this turn is laid out, for published paths; default: the largest that fits",
        "mm/s", 10.0, 20'000.0, With::curves, optional},
    RobotKey{"turns.speed",
             "the speed at which every straight and every turn begins and ends, also at the start and the goal", "mm/s",
             50.0, 20'000.0, With::turns},
    turn("turns.45", of_diagonals),
    turn("turns.90", false),
    turn("turns.135", of_diagonals),
    turn("turns.180", false),
    turn("turns.V90", of_diagonals),
    RobotKey{"turns.S90", "the whole turn, from node to node", "ms", 1.0, 10'000.0, With::turns},
    RobotKey{"search.speed",
             "speed of a search, cell by cell; low enough to stop within half a cell, and at most that of S90 unless "
             "its turns have a speed of their own",
             "mm/s", 10.0, 20'000.0, With::search_speed},
    RobotKey{"search.turn_speed",
             "speed of the quarter turns of a search, on a path of their own; default: the search speed, on the path "
             "of S90. The speed changes between the edges of the cell and the curve, and must have the room to",
             "mm/s", 10.0, 20'000.0, With::search_speed, optional},
    RobotKey{"search.pivot_speed", "speed of turning on the spot", "rad/s", 0.1, 100.0, With::search_speed},
    RobotKey{"search.pivot_acceleration", "acceleration of turning on the spot", "rad/s²", 1.0, 100'000.0,
             With::search_speed},
    RobotKey{"search.known_speed",
             "speed of a search over straights of two cells and more whose walls are all known; default: as over any",
             "mm/s", 10.0, 20'000.0, With::always, optional},
    RobotKey{"search.known_acceleration",
             "how quickly it gains that speed, and loses it again; default: the lesser of acceleration and braking",
             "mm/s²", 100.0, 200'000.0, With::always, optional},
    RobotKey{"search.cell", "straight on, from edge to edge", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.turn", "a quarter turn inside one cell, from edge to edge", "ms", 1.0, 60'000.0,
             With::search_times},
    RobotKey{"search.back", "into the middle of the cell, around, and out again", "ms", 1.0, 60'000.0,
             With::search_times},
    RobotKey{"search.quarter", "a quarter turn on the spot, at rest", "ms", 1.0, 60'000.0, With::search_times},
    RobotKey{"search.half_cell", "from rest in the middle of a cell to its edge, or the reverse", "ms", 1.0, 60'000.0,
             With::search_times},
};

}  // namespace

std::span<const RobotKey> robot_keys() {
  static const std::vector<RobotKey> keys = [] {
    std::vector<RobotKey> all(limit_keys.begin(), limit_keys.end());
    for (const HardwareKey& key : hardware_keys()) all.push_back(key.key);
    return all;
  }();
  return keys;
}

const RobotKey* find_robot_key(std::string_view name) {
  const auto keys = robot_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const RobotKey& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

const RobotKey* find_former_key(std::string_view name) {
  const auto keys = robot_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const RobotKey& key) { return key.former == name; });
  return name.empty() || found == keys.end() ? nullptr : &*found;
}

bool is_body_section(std::string_view section) {
  return section == "body" || section == "motors" || section == "sensors" || section == "noise" ||
         section == "variation" || section == infrared_list || section == ranger_list;
}

std::string_view key_in(std::string_view sentence) {
  std::string_view found;
  std::size_t first = sentence.size();
  const auto consider = [&](std::string_view key, std::string_view text) {
    const auto at = sentence.find(text);
    // Of two at the same position, the longer one is meant.
    if (at > first || at == std::string_view::npos || (at == first && text.size() <= found.size())) return;
    first = at;
    found = key;
  };
  // Short names are common words, so they count only in quotes.
  constexpr std::size_t telling = 6;
  for (const RobotKey& key : limit_keys) {
    std::string words(key.name);
    if (words.size() < telling) {
      consider(key.name, "'" + words + "'");
      continue;
    }
    consider(key.name, key.name);
    std::replace(words.begin(), words.end(), '.', ' ');
    std::replace(words.begin(), words.end(), '_', ' ');
    consider(key.name, words);
    if (words.starts_with("curve ") || words.starts_with("search pivot"))
      consider(key.name, words.substr(words.find(' ') + 1));
  }
  return found;
}

namespace {

/// "goal" or "beyond"
std::string in_quotes(std::span<const std::string_view> choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ", choices[i]);
  return text;
}

}  // namespace

std::string range_of(const RobotKey& key) {
  if (key.kind == KeyKind::yes_or_no) return "true or false";
  if (key.kind == KeyKind::choice) return in_quotes(key.choices);
  return fmt::format("{}{:.10g} to {:.10g}{}{}{}", key.kind == KeyKind::whole ? "a whole number, " : "", key.low,
                     key.high, key.unit.empty() ? "" : " ", key.unit,
                     key.kind == KeyKind::number_or_false ? ", or false" : "");
}

namespace {

/// Whether a key describes a sensor that the file has in a list.
bool is_listed(const RobotKey& key, const RobotForms& forms) {
  using Sensor = RobotKey::Sensor;
  const bool pair = key.sensor == Sensor::side || key.sensor == Sensor::front;
  return (forms.infrared_list && pair) ||
         (forms.ranger_list && key.sensor == Sensor::ranger && key.name.starts_with("sensors."));
}

}  // namespace

bool RobotForms::has(const RobotKey& key) const {
  if (key.of_diagonals && !diagonals) return false;
  if (is_listed(key, *this)) return false;
  switch (key.with) {
    case With::curves:
      return !turns;
    case With::turns:
      return turns;
    case With::search_speed:
      return !search_times;
    case With::search_times:
      return search_times;
    case With::body:
      return body;
    default:
      return true;
  }
}

std::string_view why_not(const RobotKey& key, const RobotForms& forms) {
  if (key.of_diagonals && !forms.diagonals) return "has no effect on a robot without diagonals";
  if (is_listed(key, forms))
    return key.sensor == RobotKey::Sensor::ranger ? "has no effect together with [[ranger]], which lists ToF sensors"
                                                  : "has no effect together with [[infrared]], which lists sensors";
  if (key.with == With::curves) return "has no effect together with [turns], which gives the times of all turns";
  return forms.search_times ? "has no effect together with 'search.cell', which begins a table of times"
                            : "belongs to a table of times, which also needs 'search.cell'";
}

}  // namespace labmouse
