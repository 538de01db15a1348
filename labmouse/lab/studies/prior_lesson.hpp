// A lesson: a mouse explores many mazes, and what it found becomes a prior.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "labmouse/lab/mice/prior_learning.hpp"
#include "labmouse/lab/studies/folds.hpp"

namespace labmouse {

/// What a lesson tells while it goes on.
struct LessonHooks {
  /// Called after each of `all` mazes.
  std::function<void(std::size_t all)> finished;
  /// Asked before each maze; once it is true no other is explored.
  const std::atomic<bool>* stop = nullptr;
};

struct Lesson {
  /// Which mazes count: what a study leaves out is left out here, too.
  MazeSelection selection;
  std::size_t done = 0;  ///< mazes explored, fewer than there are where it was stopped
  PriorCounts counts;
  std::string error;  ///< why there is nothing to learn from, or nothing
};

/// Learns from mazes in which a mouse can score in that world, by its rules of lessons; their order makes no
/// difference.
Lesson hold_lesson(std::vector<NamedMaze> mazes, const World& world, const LessonHooks& hooks = {});

/// The prior of a lesson as a file (see write_prior) by this version of the program.
std::string file_of(const Lesson& lesson);

/// What was learned from and how well it is foretold, and what was left out, as lines.
std::string summary_of(const Lesson& lesson);

}  // namespace labmouse
