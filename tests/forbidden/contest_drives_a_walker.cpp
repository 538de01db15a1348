// module: contest
// error: invalid initialization of reference|no matching function
//
// A contest in seconds of a strategy that was written for steps.
#include "labmouse/contest/drive.hpp"
#include "labmouse/mouse/driving_explorer.hpp"
#include "labmouse/mouse/explorer.hpp"

namespace labmouse {

#ifndef LABMOUSE_ALLOWED
using Walker = Explorer;
#else
using Walker = DrivingExplorer;
#endif

DriveRecord driven(const Maze& maze, const DriveRules& rules, const DriveModel& model, Walker& mouse) {
  return drive(maze, rules, model, mouse);
}

}  // namespace labmouse
