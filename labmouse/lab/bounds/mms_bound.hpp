// How low could anyone score in a maze under the rules of mms?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// The limits of a maze under mms's own formula; nothing where its goals, the centre, cannot be reached.
///
/// One single run is the best. The score is run + total / 10: all that is counted of a run is counted in the total as
/// well, so the total is never less than the run, and a second run only adds to it. Nothing in the rules is cheaper:
/// - a run begins with the last move out of the start cell, whose one place inside is its centre: whatever was done
///   before leaves the mouse there and shortens no run, and added to the total;
/// - a crash counts all half steps that were asked for, and more half steps never count less;
/// - ackReset adds 15 to the next run;
/// - driving through a goal ends no run, turning in it ends none that its arrival did not end.
/// The one thing to choose is free for the run alone: turns before the first move count in the total only. There is
/// one such turn at most, and a run that is shorter by the least, half a point, outweighs it.
struct MmsBound {
  /// The least effective distance + turns of a run; 0 where the start cell is a goal (up to 2×2 cells): a turn there
  /// finishes a run that never began.
  std::optional<double> run;
  /// The least score.
  std::optional<double> score;
};

MmsBound mms_bound_of(const Maze& maze);

/// The bound's witness: the lines of a mouse that knows the maze and scores the bound; empty where there is none.
std::vector<std::string> mms_best_commands(const Maze& maze);

}  // namespace labmouse
