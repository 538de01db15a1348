// Conditions of a contest in the physical world, besides rules and robot.
#pragma once

#include <vector>

#include "labmouse/body/noise_level.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/controller/controller_choice.hpp"
#include "labmouse/mouse/log_odds_map.hpp"
#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {

struct LoggedTick;

/// Default scale of the variation between mice: a factor on what each contest draws for the mouse itself. It is not
/// measured, but chosen: with it, `race --world physical --mice flood-return --noise 2 --variation FACTOR --runs 4`
/// over 260 mazes finishes as many contests as real ones, 60 to 75 % (docs/explanation/physical-model.md).
inline constexpr double field_variation = 4.25;

struct PhysicalConditions {
  NoiseLevel noise = {.variation = field_variation};
  MazeTime handling = 5'000'000;  ///< time to carry a mouse to the start and let it begin
  ControllerChoice controller;
  MapKind map = MapKind::first;
  int trace_every = 0;                     ///< ticks between two points of the trace; 0: none
  std::vector<LoggedTick>* log = nullptr;  ///< gets all ticks of a contest
};

// Limits of the conditions.

/// Largest factors of the noise and of the variation between mice.
inline constexpr double most_noise = 100.0, most_variation = 10.0;

/// Slowest pace, as a share of the usual one.
inline constexpr double least_pace = 0.2;

/// Range of the search speed, mm/s. A smaller value is in m/s, as in older records.
inline constexpr double least_search_speed = 10.0, most_search_speed = 20'000.0;

/// The hardware as the controller knows it: nominal values, and the variation between mice at noise 1, but not the
/// actual noise level.
inline Hardware told_of(const DriveModel& model, const PhysicalConditions& conditions) {
  Hardware told = *model.robot.hardware;
  told.noise = varied_by(told.noise, conditions.noise.variation);
  return told;
}

}  // namespace labmouse
