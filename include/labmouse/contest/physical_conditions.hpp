// Conditions of a contest in the physical world, besides rules and robot.
#pragma once

#include <vector>

#include "labmouse/body/error_scale.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/controller/controller_choice.hpp"
#include "labmouse/mouse/log_odds_map.hpp"

namespace labmouse {

struct LoggedTick;

/// Errors, controller and map of a contest, and what of it is written down.
struct PhysicalConditions {
  ErrorScale errors;
  MazeTime handling = 5'000'000;  ///< time to carry a mouse to the start and let it begin
  ControllerChoice controller;
  MapKind map = MapKind::first;
  int trace_every = 0;                     ///< ticks between two points of the trace; 0: none
  std::vector<LoggedTick>* log = nullptr;  ///< gets all ticks of a contest
};

// Limits of the conditions.

/// Largest factors of the noise and of the variation.
inline constexpr double most_noise = 100.0, most_variation = 10.0;

/// Slowest pace, as a share of the usual one.
inline constexpr double least_pace = 0.2;

/// Range of the search speed, mm/s. A smaller value is in m/s, as in older records.
inline constexpr double least_search_speed = 10.0, most_search_speed = 20'000.0;

}  // namespace labmouse
