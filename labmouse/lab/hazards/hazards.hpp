// What goes wrong in the physical world, and at what: contests are held, and of each manoeuvre it is counted how far
// the mouse was from where it believed to be, how far it was afterwards, and whether it crashed; and of each reading of
// a wall whether it was wrong.
//
// Counts are by how far the mouse was astray as the manoeuvre began, because that is what makes the next one go wrong:
// a mouse that knows where it is neither misreads nor crashes.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/drive_rules.hpp"
#include "labmouse/contest/physical_conditions.hpp"
#include "labmouse/contest/physical_record.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/maze/maze.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

/// What a mouse does from one place to the next: a move of a search or of a way home, or a segment of a fast run.
enum class Manoeuvre : std::uint8_t {
  open_cell,  ///< straight through a cell without a wall beside
  half_cell,  ///< with one
  corridor,   ///< with two
  dash,       ///< straight through several known cells
  turn,       ///< a quarter turn through a cell
  halt,       ///< to rest in a cell, and turned on the spot
  start,      ///< from rest out of a cell
  run_straight,
  run_diagonal,
  run_turn,
};

inline constexpr std::array all_manoeuvres = {
    Manoeuvre::open_cell, Manoeuvre::half_cell, Manoeuvre::corridor,     Manoeuvre::dash,         Manoeuvre::turn,
    Manoeuvre::halt,      Manoeuvre::start,     Manoeuvre::run_straight, Manoeuvre::run_diagonal, Manoeuvre::run_turn};

constexpr std::string_view name_of(Manoeuvre manoeuvre) {
  constexpr std::array<std::string_view, all_manoeuvres.size()> names = {
      "open cell", "half cell", "corridor",     "dash",         "turn",
      "halt",      "start",     "run straight", "run diagonal", "run turn"};
  return names[static_cast<std::size_t>(manoeuvre)];
}

/// How far astray a mouse is, by the distance between where it is and where it believes to be: below 2, 4, 8 and 16 %
/// of a cell, and beyond.
inline constexpr std::array<double, 4> astray_limits = {0.02, 0.04, 0.08, 0.16};
inline constexpr std::size_t astray_levels = astray_limits.size() + 1;

/// The level of a distance, as a share of a cell.
constexpr std::size_t astray_level(double share) {
  std::size_t level = 0;
  while (level < astray_limits.size() && share >= astray_limits[level]) ++level;
  return level;
}

/// Manoeuvres of one kind that began with the mouse as far astray.
struct ManoeuvreCount {
  std::int64_t times = 0;
  std::int64_t crashes = 0;
  std::array<std::int64_t, astray_levels> after{};  ///< how far it was astray at the end of those without a crash

  ManoeuvreCount& operator+=(const ManoeuvreCount& other);
};

/// What is read: whether the wall is there, and whether it is ahead or beside.
enum class Reading : std::uint8_t { wall_beside, gap_beside, wall_ahead, gap_ahead };

inline constexpr std::array all_readings = {Reading::wall_beside, Reading::gap_beside, Reading::wall_ahead,
                                            Reading::gap_ahead};

constexpr std::string_view name_of(Reading reading) {
  constexpr std::array<std::string_view, all_readings.size()> names = {"wall beside", "gap beside", "wall ahead",
                                                                       "gap ahead"};
  return names[static_cast<std::size_t>(reading)];
}

/// Readings of inner walls; those that say nothing are neither right nor wrong.
struct ReadingCount {
  std::int64_t times = 0;
  std::int64_t wrong = 0;
  std::int64_t silent = 0;

  ReadingCount& operator+=(const ReadingCount& other);
};

/// All that was counted under one noise.
struct HazardTally {
  double noise = 0.0;
  std::int64_t contests = 0;
  std::int64_t finished = 0;  ///< with a score
  std::array<std::array<ManoeuvreCount, astray_levels>, all_manoeuvres.size()> manoeuvres{};
  std::array<std::array<ReadingCount, astray_levels>, all_readings.size()> readings{};

  HazardTally& operator+=(const HazardTally& other);
  /// Of manoeuvres of that kind, however far astray; of all kinds that far astray.
  ManoeuvreCount of(Manoeuvre manoeuvre) const;
  ManoeuvreCount at(std::size_t level) const;
};

/// Counts what happened in a contest whose mouse told where it believed to be, with a point of the trace every few
/// ticks. What a mouse does behind the goal of a fast run counts nowhere, and neither does what it did when the time
/// was over.
void count_hazards(const PhysicalRecord& record, const Maze& maze, double cell, HazardTally& tally);

struct HazardOrder {
  std::shared_ptr<const DriveModel> model;
  DriveRules rules;
  PhysicalConditions conditions;  ///< but for their noise
  std::vector<double> noises;
  int runs = 1;  ///< contests of each mouse in each maze, under each noise
  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads; 0: all processors
};

/// Holds all contests of mice that decide by Strategy; each has a seed of its own, the same under each noise and the
/// same as in a race of that seed.
std::vector<HazardTally> measure_hazards(const HazardOrder& order, std::span<const Contestant> mice,
                                         std::span<const NamedMaze> mazes, const std::atomic<bool>* stop = nullptr);

std::string table_of(std::span<const HazardTally> tallies);
std::string json_of(std::span<const HazardTally> tallies, const HazardOrder& order, std::span<const Contestant> mice);

}  // namespace labmouse
