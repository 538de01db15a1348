// What a mouse knows before it is put into the maze.
#pragma once

#include <cstdint>

#include "labmouse/grid/cell_set.hpp"
#include "labmouse/mouse/motion.hpp"
#include "labmouse/mouse/pose.hpp"

namespace labmouse {

class DriveFields;
struct DriveModel;

/// What a mouse knows of a world in seconds, one whose scores are times: its robot, and the rules that matter for its
/// plans.
struct DriveBriefing {
  const DriveModel* model = nullptr;  ///< null in the other worlds; must outlive the mouse
  std::int64_t time_limit = 0;        ///< microseconds in the maze
  double pace = 1.0;                  ///< search pace as a share of the usual one
  int maze_time_divisor = 0;          ///< this many microseconds in the maze count as one of a run; 0: none count
  int most_runs = 5;                  ///< runs that may begin at the start, search runs among them
  std::int64_t untouched_bonus = 0;   ///< microseconds off the runs of a mouse that was never touched
  /// The fields to plan with, if the caller provides them: made for this maze and model, used by this mouse alone, and
  /// outliving it. Null: the mouse allocates its own.
  DriveFields* fields = nullptr;
};

/// What a mouse knows of its contest before it starts.
struct Briefing {
  /// Size of the maze; each side is at most max_side cells, or max_drive_side in the worlds in seconds.
  Size size;
  /// Where each run begins.
  Pose start;
  /// At least one cell; a run ends in any of them.
  CellSet goals;
  /// The moves of the world of steps and their costs.
  Motion motion = strides();
  /// Most steps of both runs together; a reset counts as one.
  int budget = 1000;
  /// The seed of stochastic mice, and their only source of randomness.
  std::uint64_t seed = 0;
  /// Range of a reading in cells, 1 or more. A reading of this many cells shows no wall at its end.
  int sight = max_side;
  DriveBriefing drive = {};
  /// Whether the contest records the reasons of the mouse's decisions.
  bool reasons = false;

  /// Whether the world is one of those in seconds.
  bool in_seconds() const { return drive.model != nullptr; }
};

}  // namespace labmouse
