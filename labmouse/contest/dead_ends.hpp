// Dead ends that a search run has seen, for rules that count them.
#pragma once

#include "labmouse/contest/drive_record.hpp"
#include "labmouse/maze/maze.hpp"

namespace labmouse {

/// What a search run has seen until it first entered a goal, by its moves; nothing for other runs, and for searches
/// that did not reach a goal. A dead end is a reachable cell with one open wall, apart from the start and the goals; a
/// mouse sees it as it enters it.
std::optional<DeadEndCount> dead_ends_of(const DriveRun& run, const Maze& maze);

/// The dead ends of a maze.
CellSet dead_ends_in(const Maze& maze);

}  // namespace labmouse
