// The figures of the world of steps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "labmouse/lab/races/race.hpp"

namespace labmouse {

struct StepsFigures : Figures {
  std::int64_t search_steps = 0;
  std::optional<std::int64_t> speed_steps;  ///< nothing where the contest was not finished
  double discovered = 0.0, visited = 0.0;   ///< shares of the reachable cells
  /// All four have a value if at least one of them is not 0.
  LeftOut<std::int64_t> blocked_steps, void_rotations, cut_movements, idle_resets;
  std::int64_t first_action_error = 0;  ///< number of the first step with an action error; 0 without one
  LeftOut<std::string> words;           ///< what the mouse had to say
  LeftOut<JsonText> counts;             ///< an object of what the mouse counted
  std::int64_t decisions = 0;
  ByClock microseconds;  ///< of real time for all decisions
};

}  // namespace labmouse
