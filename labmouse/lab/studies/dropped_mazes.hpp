// Notes on the mazes that a selection leaves out.
#pragma once

#include <string>
#include <string_view>

#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

/// Printable lines with the duplicates and the mazes without a route, up to ten of each; empty where there are none.
/// `elsewhere` ends the line that counts the others, and says where they are listed.
std::string left_out_notes(const MazeSelection& selection, std::string_view elsewhere);

}  // namespace labmouse
