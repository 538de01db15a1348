// Learning a prior: a mouse explores many mazes and counts their walls.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/mice/prior_learning.hpp"
#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

/// Callbacks of a lesson.
struct LessonHooks {
  /// Called after each maze with the number of all mazes.
  std::function<void(std::size_t all)> finished;
  /// Read before each maze; once it is true, no further maze is explored.
  const std::atomic<bool>* stop = nullptr;
};

/// The result of hold_lesson(): counts of walls, from which a prior is made.
struct Lesson {
  /// The mazes used, selected as for a study.
  MazeSelection selection;
  std::size_t done = 0;  ///< number of explored mazes; fewer than the selected ones where it was stopped
  PriorCounts counts;
  std::string error;  ///< why nothing could be learned; empty on success
};

/// Learns from the mazes in which a mouse can score in that world, under its rules in steps. The order of the mazes
/// makes no difference.
Lesson hold_lesson(std::vector<NamedMaze> mazes, const World& world, const LessonHooks& hooks = {});

/// The prior of a lesson as the text of a file (see write_prior), marked with this version of the program.
std::string file_of(const Lesson& lesson);

/// Lines about the mazes, the quality of the predictions, and the mazes left out.
std::string summary_of(const Lesson& lesson);

}  // namespace labmouse
