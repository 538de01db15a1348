// The world of mms, the simulator, for programs that were written for it.
#pragma once

#include <memory>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mms/mms_figures.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// How mms scores, as a formula over the names of `getStat`.
inline constexpr const char* mms_formula =
    "best-run-effective-distance + best-run-turns + 0.1 * (total-effective-distance + total-turns); 2000 while "
    "unsolved";

/// Hosts each program once in each maze. Of log and errors the figures have the ends only: many runs have to fit into
/// memory.
std::shared_ptr<const World> mms_world(const MmsOptions& options = {});

/// Fills in what is left of the result of a contest that went so: a run that visited those cells, in a maze with the
/// facts that the world has of it.
void sum_up(const MmsRun& run, const CellSet& visited, const MazeFacts& facts, ContestResult& result);

}  // namespace labmouse
