// What is kept of a contest in steps.
#pragma once

#include <string>

#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// What is kept of a contest.
ContestOutput kept(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                   RunRecord record, Keep keep);

/// The record of a contest as a file.
RecordFile record_file_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                          const RunRecord& record);

}  // namespace labmouse
