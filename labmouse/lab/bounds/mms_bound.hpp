// Lower bounds of the score in a maze under the rules of mms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// Lower bounds for a maze under mms's formula; empty where its goals, the cells at the centre, cannot be reached.
///
/// A single run is optimal. The score is run + total / 10, and the total contains the run, so a second run only adds to
/// it. No other rule makes a run cheaper:
/// - a run begins with the last move out of the start cell, and this move always begins at the centre of that cell:
///   earlier actions add to the total and shorten no run;
/// - a crash counts all half steps of its command, and more half steps never cost less;
/// - ackReset adds 15 to the next run;
/// - driving through a goal ends no run, and a turn in a goal ends no run that the arrival did not end.
/// Turns before the first move count in the total only, and the best run has at most one of them. That turn costs 0.1
/// points, less than the least difference between two runs (half a point). So the shortest run also gives the least
/// score.
struct MmsBound {
  /// The least effective distance + turns of a run. It is 0 where the start cell is a goal (mazes up to 2×2 cells): mms
  /// then counts a turn at the start as a finished run.
  std::optional<double> run;
  /// The least score.
  std::optional<double> score;
};

MmsBound mms_bound_of(const Maze& maze);

/// The mms commands of a mouse that scores the bound; empty where there is no route.
std::vector<std::string> mms_best_commands(const Maze& maze);

}  // namespace labmouse
