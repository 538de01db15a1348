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
    row<&MmsOptions::strict>({.name = "strict",
                              .meaning = "End a run at the first line that mms would not answer",
                              .default_value = "false"}),
    row<&MmsOptions::presses>({.name = "presses",
                               .placeholder = "N",
                               .meaning = "Press Reset N times when a mouse waits for it",
                               .default_value = "0",
                               .high = 1'000'000}),
    row<&MmsOptions::most_seconds>({.name = "simulated-limit",
                                    .placeholder = "SECONDS",
                                    .meaning = "End a run after this simulated time; its best run counts",
                                    .default_value = "3600",
                                    .low = 1,
                                    .high = 1'000'000}),
    row<&MmsOptions::most_lines>({.name = "line-limit",
                                  .placeholder = "N",
                                  .meaning = "End a run after N lines; its best run counts",
                                  .default_value = "10000000",
                                  .low = 1,
                                  .high = 2'000'000'000})};

/// Hosts each program once in each maze. The figures keep only the first sentences of the log and the last lines of
/// standard error, so that many runs fit into memory.
std::shared_ptr<const World> mms_world(const MmsOptions& options = {});

/// Completes the result of a contest from its run, the cells that it visited, and the facts of its maze.
void sum_up(const MmsRun& run, const CellSet& visited, const MazeFacts& facts, ContestResult& result);

}  // namespace labmouse
