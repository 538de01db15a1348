// A contest in steps as a picture and in lines of text.
#pragma once

#include <functional>
#include <string>

#include "labmouse/lab/drawing/drawing.hpp"
#include "labmouse/lab/records/record_file.hpp"

namespace labmouse {

/// The picture of a contest: the speed run over the visits of the search run.
std::string picture_of(const RecordFile& file);

/// The title of a picture of a contest: the mouse (of a long command its end), the maze, and how it went.
std::string title_of(const RecordFile& file);

/// How much of the maze its search run discovered and visited, in one line without its end.
std::string search_run_line(const RecordFile& file);

/// How a contest went, in one line without its end: the mouse, the maze, the outcome, and the score or
/// where the mouse stood.
std::string result_line(const RecordFile& file);

/// For a record that lacks fields, which part of it a replay checks against the maze, in one line without its end;
/// empty if the record has all fields.
std::string checked_line(const RecordFile& file);

/// What the mouse had to say: where it gave up, what went wrong; then the last lines of what it wrote. Empty for most.
std::string last_words_lines(const RecordFile& file);

/// What the mouse counted, in one line without its end; empty where it counted nothing.
std::string counts_line(const RecordFile& file);

/// An action in words: "turn -90, move +1".
std::string action_words(const Action& action);

/// A line for each kind of action error of a contest, with the first such step; empty where there is none.
std::string action_error_lines(const RecordFile& file);

/// The maze with the speed run, a line on what the search run saw, what the mouse counted, steps that were not
/// performed as it asked, and how the contest went.
std::string summary_of(const RecordFile& file, const TextDrawer& draw);

/// Draws every step with what the mouse knows by then.
void animate(const RecordFile& file, const TextDrawer& draw, const std::function<void(const std::string&)>& show);

}  // namespace labmouse
