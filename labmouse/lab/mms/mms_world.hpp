// The world of mms, the simulator, for programs that were written for it.
#pragma once

#include <array>
#include <memory>

#include "labmouse/external/mms/run.hpp"
#include "labmouse/lab/mms/mms_figures.hpp"
#include "labmouse/lab/races/race.hpp"

namespace labmouse {

/// How mms scores, as a formula over the names of `getStat`.
inline constexpr const char* mms_formula =
    "best-run-effective-distance + best-run-turns + 0.1 * (total-effective-distance + total-turns); 2000 while "
    "unsolved";

/// What can be set of the world.
inline constexpr std::array mms_rows = {
    row<&MmsOptions::strict>({"strict", "", "End a run at the first line that mms would not answer", "false"}),
    row<&MmsOptions::presses>({"presses", "N", "Press Reset N times when a mouse waits for it", "0", 0, 1'000'000}),
    row<&MmsOptions::most_seconds>({"simulated-limit", "SECONDS",
                                    "End a run after this simulated time; its best run counts", "3600", 1, 1'000'000}),
    row<&MmsOptions::most_lines>(
        {"line-limit", "N", "End a run after N lines; its best run counts", "10000000", 1, 2'000'000'000})};

/// Hosts each program once in each maze. Of log and errors the figures have the ends only: many runs have to fit into
/// memory.
std::shared_ptr<const World> mms_world(const MmsOptions& options = {});

/// Fills in what is left of the result of a contest that went so: a run that visited those cells, in a maze with the
/// facts that the world has of it.
void sum_up(const MmsRun& run, const CellSet& visited, const MazeFacts& facts, ContestResult& result);

}  // namespace labmouse
