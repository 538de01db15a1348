// Files that hold mazes: drawings, tables, records, results, stores, pictures.
#pragma once

#include <string>

#include "labmouse/external/hidden_files.hpp"

namespace labmouse {

/// Hides the files in the folder of an external mouse in which it could look up a maze, whoever put them there: many
/// robots of the capstone project lie beside its mazes. Each folder is looked through once. Looks at 4000 files at
/// most, and not into what is hidden or installed there (.git, node_modules, virtual environments).
void hide_mazes_in(const std::string& folder, HiddenFiles& hidden);

/// Whether the file holds a maze, as far as its content says it.
bool holds_maze(const std::string& path);

}  // namespace labmouse
