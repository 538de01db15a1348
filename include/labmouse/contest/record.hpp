// Complete record of one contest in the world of steps, step by step.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/pose.hpp"
#include "labmouse/mouse/reasons.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// The two runs of a contest.
enum class Run : std::uint8_t { search_run, speed };

/// How a contest ended.
enum class Outcome : std::uint8_t {
  finished,              ///< the speed run ended in a goal
  out_of_steps,          ///< the budget ended before a step of the search run ended in a goal
  never_reset,           ///< a goal was entered, and the budget ended before the mouse went back to the start
  speed_run_unfinished,  ///< the budget ended in the speed run
  forfeit,               ///< the mouse gave up; the last step's action has the reason
};

/// The name of an outcome, for records and tables.
/// @param outcome one of the five.
/// @return in static memory; "unknown" for any other number.
constexpr std::string_view name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::out_of_steps:
      return "out of steps";
    case Outcome::never_reset:
      return "never reset";
    case Outcome::speed_run_unfinished:
      return "speed run unfinished";
    case Outcome::forfeit:
      return "forfeit";
  }
  return "unknown";
}

/// One step: pose, reading and action of the mouse.
struct StepRecord {
  Run run = Run::search_run;
  /// Number of the step, from 1 over both runs.
  int step = 0;
  Pose pose;             ///< before the action
  Sighting sighting;     ///< as read in that pose
  Action action;         ///< as asked for
  bool blocked = false;  ///< a wall ended the movement early

  friend constexpr bool operator==(const StepRecord&, const StepRecord&) = default;
};

/// A named counter of a strategy.
struct Count {
  std::string name;
  std::int64_t value = 0;

  friend bool operator==(const Count&, const Count&) = default;
};

/// Reasons of a strategy's choice in a step.
struct StepReasons {
  int step = 0;  ///< its number
  Reasons reasons;

  friend bool operator==(const StepReasons&, const StepReasons&) = default;
};

/// One contest of one mouse in one maze.
struct RunRecord {
  std::vector<StepRecord> steps;
  Outcome outcome = Outcome::out_of_steps;
  /// Where the mouse stood at the end.
  Pose end;
  /// Text for people, in lines of any encoding; see Strategy::last_words.
  std::string last_words;
  /// The mouse's own counters at the end, sorted by name.
  std::vector<Count> counts;
  /// The reasons of the steps in which the strategy made a new choice, in order; empty unless asked for.
  std::vector<StepReasons> reasons;

  friend bool operator==(const RunRecord&, const RunRecord&) = default;
};

}  // namespace labmouse
