// What the tasks of a file come to: a world, its mazes, and which task is about which of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "labmouse/lab/grading/task_file.hpp"
#include "labmouse/lab/mazes/maze_files.hpp"
#include "labmouse/lab/races/world.hpp"

namespace labmouse {

/// A maze of one or several tasks.
struct GradedMaze {
  NamedMaze maze;       ///< named as in the task file, or "hidden 1"
  bool hidden = false;  ///< whether nothing of it may get to students
};

/// A plan, or errors.
struct GradingPlan {
  TaskFile file;
  std::shared_ptr<const World> world;
  /// Each maze once, in the order in which the tasks name them.
  std::vector<GradedMaze> mazes;
  /// For each task its mazes, as positions in `mazes`.
  std::vector<std::vector<std::size_t>> mazes_of;
  /// The files of the mazes and the task file, which programs must not see.
  std::vector<std::string> files;
  std::vector<std::string> errors;   ///< one line each, with the place in the task file
  std::vector<std::string> remarks;  ///< on files that are no mazes, and on settings, one line each
};

/// Loads and generates the mazes, and makes the world.
/// @param file as read; hidden mazes need its seed.
/// @param path of the task file: paths in it are relative to its folder.
GradingPlan plan_grading(TaskFile file, const std::string& path);

}  // namespace labmouse
