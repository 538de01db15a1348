// What a contest in the physical world is held under, besides its rules and its robot.
#pragma once

#include "labmouse/body/noise_level.hpp"
#include "labmouse/contest/drive_record.hpp"
#include "labmouse/mouse/belief.hpp"
#include "labmouse/pilot/pilot.hpp"

namespace labmouse {

struct PhysicalConditions {
  NoiseLevel noise;
  MazeTime handling = 5'000'000;  ///< that it takes to carry a mouse to the start and let it begin
  PilotChoice pilot;
  MapKind map = MapKind::first;
  int trace_every = 0;  ///< ticks between two points of the trace; 0: none
};

/// What a pilot knows of its hardware: the book, and how far mice like it are spread at noise 1; not how much noise
/// there is today.
inline Hardware told_of(const DriveModel& model, const PhysicalConditions& conditions) {
  Hardware told = *model.robot.hardware;
  told.noise = spread_by(told.noise, conditions.noise.spread);
  return told;
}

}  // namespace labmouse
