// What a mouse knows before it is put into the maze.
#pragma once

#include <cstdint>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

class DriveFields;
struct DriveModel;

/// What a mouse knows of the world in seconds: its robot, and what of the rules it can go by.
struct DriveBriefing {
  const DriveModel* model = nullptr;  ///< null in the other worlds; must outlive the mouse
  std::int64_t time_limit = 0;        ///< microseconds in the maze
  double pace = 1.0;                  ///< the part of its usual pace at which it will search
  int maze_time_divisor = 0;          ///< so many microseconds in the maze count as one of a run; 0 where they do not
  int most_runs = 5;
  std::int64_t untouched_bonus = 0;  ///< microseconds off the runs of a mouse that no hand has touched
  /// Where the mouse is to plan, if its memory is somebody else's: made for this maze and model, for this mouse alone,
  /// and outlives it. Null: it takes its own.
  DriveFields* fields = nullptr;
};

struct Briefing {
  Size size;
  Pose start;
  CellSet goals;
  Motion motion = strides();
  /// Steps over both runs, the reset's among them.
  int budget = 1000;
  /// For mice that are stochastic: all their chance comes from here.
  std::uint64_t seed = 0;
  /// Cells that a reading reaches at most, 1 or more: a reading of so many shows no wall at its end.
  int sight = max_side;
  DriveBriefing drive = {};
  /// Whether the contest keeps the reasons of its decisions, if it has some.
  bool reasons = false;

  bool in_seconds() const { return drive.model != nullptr; }
};

}  // namespace labmouse
