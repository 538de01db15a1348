// Finds files that contain mazes: drawings, tables, records, results, stores, pictures, reports.
#pragma once

#include <string>

#include "labmouse/external/hidden_files.hpp"

namespace labmouse {

/// Most files of a folder that are searched.
inline constexpr int most_searched = 4000;

/// Hides from an external mouse the files in a folder that it sees that contain mazes; many capstone robots are kept
/// beside the mazes of the project. Each folder is searched once, without what lies in hidden folders or in installed
/// packages (.git, node_modules, virtual environments). `hidden` notes it where it has more files than are searched.
void hide_mazes_in(const std::string& folder, HiddenFiles& hidden);

/// Whether the file contains a maze, judged by its content; pictures and pages always count, also by their endings,
/// and two files of a build of labmouse are known by their names.
bool holds_maze(const std::string& path);

}  // namespace labmouse
