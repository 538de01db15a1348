// Classes by which failure rates are counted: manoeuvres, localization errors, and wall readings.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/drive/search_motion.hpp"
#include "labmouse/mouse/robot/route.hpp"

namespace labmouse {

/// Kinds of moves: of a search or of a way home, and segments of a speed run.
enum class Manoeuvre : std::uint8_t {
  open_cell,  ///< straight through a cell without side walls
  half_cell,  ///< with one side wall
  corridor,   ///< with two side walls
  dash,       ///< straight through several known cells
  turn,       ///< a quarter turn through a cell
  turn_back,  ///< stop in a cell, turn by 180 degrees, and out of it
  halt,       ///< stop in a cell, and a turn on the spot
  start,      ///< from rest out of a cell
  run_straight,
  run_diagonal,
  run_turn,
};

inline constexpr std::array all_manoeuvres = {Manoeuvre::open_cell,    Manoeuvre::half_cell, Manoeuvre::corridor,
                                              Manoeuvre::dash,         Manoeuvre::turn,      Manoeuvre::turn_back,
                                              Manoeuvre::halt,         Manoeuvre::start,     Manoeuvre::run_straight,
                                              Manoeuvre::run_diagonal, Manoeuvre::run_turn};

constexpr std::string_view name_of(Manoeuvre manoeuvre) {
  constexpr std::array<std::string_view, all_manoeuvres.size()> names = {
      "open cell", "half cell", "corridor",     "dash",         "turn",    "turn back",
      "halt",      "start",     "run straight", "run diagonal", "run turn"};
  return names[static_cast<std::size_t>(manoeuvre)];
}

/// The class of driving straight through the cell of that pose, by its side walls.
Manoeuvre straight_through(const Maze& maze, const Pose& pose);
/// The class of a search move: over one edge, a dash or to rest.
Manoeuvre manoeuvre_of(const Maze& maze, const SearchPlace& from, const Action& action);
/// The class of a segment of a speed run.
Manoeuvre manoeuvre_of(const DriveSegment& segment);

/// Levels of the localization error (distance between true and believed position): below 2, 4, 8 and 16 % of a cell,
/// and beyond.
inline constexpr std::array<double, 4> position_error_limits = {0.02, 0.04, 0.08, 0.16};
inline constexpr std::size_t position_error_levels = position_error_limits.size() + 1;

/// The level of a distance, as a share of a cell.
constexpr std::size_t position_error_level(double share) {
  std::size_t level = 0;
  while (level < position_error_limits.size() && share >= position_error_limits[level]) ++level;
  return level;
}

/// Kinds of wall readings: wall or gap, ahead or beside, first or repeated. Walls that are read again in a contest are
/// those that were hard to read.
enum class Reading : std::uint8_t {
  wall_beside,
  gap_beside,
  wall_ahead,
  gap_ahead,
  wall_beside_again,
  gap_beside_again,
  wall_ahead_again,
  gap_ahead_again
};

inline constexpr std::array all_readings = {
    Reading::wall_beside,       Reading::gap_beside,       Reading::wall_ahead,       Reading::gap_ahead,
    Reading::wall_beside_again, Reading::gap_beside_again, Reading::wall_ahead_again, Reading::gap_ahead_again};

constexpr std::string_view name_of(Reading reading) {
  constexpr std::array<std::string_view, all_readings.size()> names = {
      "wall beside",       "gap beside",       "wall ahead",       "gap ahead",
      "wall beside again", "gap beside again", "wall ahead again", "gap ahead again"};
  return names[static_cast<std::size_t>(reading)];
}

constexpr Reading reading_of(bool open, bool ahead, bool again) {
  return static_cast<Reading>((open ? 1 : 0) + (ahead ? 2 : 0) + (again ? 4 : 0));
}
constexpr bool is_of_wall(Reading reading) { return static_cast<int>(reading) % 2 == 0; }

}  // namespace labmouse
