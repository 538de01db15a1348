// Task files: what the mice of a class are graded by. docs/reference/files.md describes them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mazes/secret_mazes.hpp"
#include "labmouse/lab/mice_files/file_limits.hpp"
#include "labmouse/lab/worlds/world_table.hpp"
#include "labmouse/maze/formats/format.hpp"

namespace labmouse {

/// A figure of a contest, and the largest value of it that fulfils a task.
struct FigureLimit {
  std::string figure;  ///< a key of a contest in JSON, or one of the names below
  double most = 0.0;
};

/// Figures that are no keys of a contest in JSON in every world.
inline constexpr std::string_view score_figure = "score";  ///< in the unit of the world
inline constexpr std::string_view ratio_figure = "ratio";  ///< of the score to the best possible one
inline constexpr std::string_view known_wall_hits_figure = "known_wall_hits";  ///< in worlds with steps

/// One task.
struct Task {
  std::string name;
  double points = 0.0;
  std::vector<std::string> mazes;  ///< as --mazes takes them
  SecretMazes hidden;              ///< mazes that students do not see
  bool finish = false;             ///< whether contests have to be finished
  std::vector<FigureLimit> at_most;
  bool per_maze = false;     ///< whether each contest is judged on its own and gives an equal share of the points
  int line = 0, column = 0;  ///< of the task in its file, from 1
};

/// A task file, as written.
struct TaskFile {
  std::string seed;  ///< the secret seed of hidden mazes; may be empty
  NamedWorld world;
  std::optional<int> runs;
  FileLimits limits;
  bool show_hidden = false;  ///< whether students see the hidden mazes
  std::vector<Task> tasks;
};

/// Either tasks, or the problems of their file.
struct TaskFileResult {
  TaskFile file;
  std::vector<Problem> problems;
};

/// Reads a task file of at most 64 KiB.
TaskFileResult read_task_file(std::string_view text);

}  // namespace labmouse
