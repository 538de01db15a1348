// Computes from a record how much of a maze a search in seconds saw and visited.
#pragma once

#include "labmouse/contest/coverage.hpp"
#include "labmouse/contest/drive_record.hpp"

namespace labmouse {

/// The cells that were known and driven through before the first speed run, as shares of the reachable ones (at least
/// one). A cell is known where it was driven through, or where an open wall was seen that leads into it.
Coverage coverage_of(const DriveRecord& record, const Maze& maze, const CellSet& reachable);

}  // namespace labmouse
