// Which mazes of a selection do not count, in words.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

/// Lines that name the duplicates and the mazes without a route, up to ten of each, printable; empty where there is
/// none. `elsewhere` ends the line that counts the others, and says where they stand.
std::string left_out_notes(const MazeSelection& selection, std::string_view elsewhere);

}  // namespace labmouse
