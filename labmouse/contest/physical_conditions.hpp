// What a contest in the physical world is held under, besides its rules and its robot.
#pragma once

#include "labmouse/body/noise_level.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/controller/controller.hpp"
#include "labmouse/mouse/log_odds_map.hpp"

namespace labmouse {

/// How far contests are apart: the factor of what each of them draws of the mouse itself. Nobody has measured it; it
/// was chosen so that at noise 2 as many contests come to a score as in the field, 60 to 75 %, by `race --world
/// physical --mice flood-return --noise 2 --spread FACTOR --runs 4` over 260 mazes: docs/explanation/physical-model.md,
/// "How hard is real?".
inline constexpr double field_variation = 4.25;

struct PhysicalConditions {
  NoiseLevel noise = {.variation = field_variation};
  MazeTime handling = 5'000'000;  ///< that it takes to carry a mouse to the start and let it begin
  ControllerChoice controller;
  MapKind map = MapKind::first;
  int trace_every = 0;  ///< ticks between two points of the trace; 0: none
};

// What conditions can be, for all who read them.

/// Factors of the noise and of how far contests are apart.
inline constexpr double most_noise = 100.0, most_variation = 10.0;

/// As slowly as a mouse can be driven, as a part of its usual pace.
inline constexpr double least_pace = 0.2;

/// Speeds of a search that can be chosen, in mm/s. Less is no speed of a mouse, but one in m/s; older records have it.
inline constexpr double least_search_speed = 10.0, most_search_speed = 20'000.0;

/// What a controller knows of its hardware: the nominal values, and how far mice like it are spread at noise 1; not how
/// much noise there is today.
inline Hardware told_of(const DriveModel& model, const PhysicalConditions& conditions) {
  Hardware told = *model.robot.hardware;
  told.noise = varied_by(told.noise, conditions.noise.variation);
  return told;
}

}  // namespace labmouse
