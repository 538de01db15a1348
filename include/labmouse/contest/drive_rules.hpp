// The rules of a contest in seconds. docs/reference/worlds-and-rules.md explains them; rules/*.toml are the built-in
// ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace labmouse {

/// What the rules score: a run from the start to a goal; in a time trial, a lap of the outermost ring of the maze; or
/// the dead ends that a search sees before it enters a goal.
enum class Counted : std::uint8_t { run, lap, dead_end };

/// All that rules can score, in the order of the enumeration.
inline constexpr std::array all_counted = {Counted::run, Counted::lap, Counted::dead_end};

/// The name of what rules score.
/// @param counted one of the three.
/// @return "run", "lap" or "dead end"; in static memory.
constexpr std::string_view name_of(Counted counted) {
  return counted == Counted::run ? "run" : counted == Counted::lap ? "lap" : "dead end";
}

/// What rules score, by its name.
/// @param name as name_of() gives it.
/// @return nullopt for any other name.
constexpr std::optional<Counted> counted_named(std::string_view name) {
  for (const Counted counted : all_counted)
    if (name_of(counted) == name) return counted;
  return std::nullopt;
}

/// The unit of a score.
/// @param counted what the rules score.
/// @return "s", or "marks lost" if dead ends count; in static memory.
constexpr std::string_view unit_of(Counted counted) { return counted == Counted::dead_end ? "marks lost" : "s"; }

/// The rules of one kind of contest. Lower scores are better.
struct DriveRules {
  std::string name;
  std::string source;  ///< where and when they were in force, and what is uncertain
  /// Time in the maze, in microseconds, from the first start on; a run that has not ended by then does not count.
  std::int64_t time_limit = 0;
  Counted counts = Counted::run;
  /// Runs that may begin at the start, searches among them. If laps count: laps that may be completed.
  int most_runs = 5;
  /// If dead ends count: full marks. The score is what a mouse loses of them, so lower is better here, too.
  int marks = 0;
  /// A run counts its own time and this part of the time in the maze before it began: 0, or 1/30.
  int maze_time_divisor = 0;  ///< 30 for a thirtieth; 0 if the maze time does not count
  /// Whether the clock runs from gate to gate (leaves the start cell, enters a goal cell) or from rest to the centre of
  /// the goal.
  bool gate_to_gate = true;
  /// Microseconds added to the time of a run after the mouse was touched, which happens only in worlds with errors.
  std::int64_t touch_penalty = 0;
  /// Microseconds subtracted from a run if the mouse was never touched before it.
  std::int64_t untouched_bonus = 0;
};

}  // namespace labmouse
