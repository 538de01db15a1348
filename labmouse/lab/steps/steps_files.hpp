// A contest in steps as a file, as a picture and in lines of text.
#pragma once

#include <string>

#include "labmouse/lab/races/world.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// What is kept of a contest.
Held kept(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed, RunRecord record,
          Keep keep);

/// The record of a contest as a file.
RecordFile record_file_of(const Contestant& mouse, const NamedMaze& maze, const Rules& rules, std::uint64_t seed,
                          const RunRecord& record);

/// The picture of a contest: the speed run over the visits of the exploration.
std::string picture_of(const RecordFile& file);

/// The title of a picture of a contest: the mouse (of a long command its end), the maze, and how it went.
std::string title_of(const RecordFile& file);

/// How much of the maze its exploration discovered and visited, in one line without its end.
std::string exploration_line(const RecordFile& file);

/// How a contest went, in one line without its end: the mouse, the maze, the outcome, and the score or
/// where the mouse stood.
std::string result_line(const RecordFile& file);

/// How much of a record that lacks fields a replay compares with the maze, in one line without its end; empty where the
/// record gives all.
std::string checked_line(const RecordFile& file);

/// What the mouse had to say: where it gave up, what went wrong; then the last lines of what it wrote. Empty for most.
std::string last_words_lines(const RecordFile& file);

/// What the mouse counted, in one line without its end; empty where it counted nothing.
std::string counts_line(const RecordFile& file);

}  // namespace labmouse
