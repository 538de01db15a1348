#include "labmouse/lab/studies/prior_lesson.hpp"

#include <fmt/format.h>

#include "labmouse/lab/mice/prior_file.hpp"
#include "labmouse/lab/studies/dropped_mazes.hpp"
#include "labmouse/lab/system/version.hpp"

namespace labmouse {
namespace {

std::string words_of(const Lesson& lesson) {
  const std::size_t all = lesson.selection.mazes.size();
  if (lesson.done < all)
    return fmt::format("Stopped early: {} of {} mazes explored, no prior written.\n", lesson.done, all);
  const PriorFit fit = fit_of(lesson.counts);
  return fmt::format("{} {}, {} walls counted: log loss {:.3f}, entropy {:.3f} nats per wall\n", all,
                     all == 1 ? "maze" : "mazes", fit.walls, fit.log_loss, fit.entropy);
}

}  // namespace

Lesson hold_lesson(std::vector<NamedMaze> mazes, const World& world, const LessonHooks& hooks) {
  Lesson lesson;
  const std::size_t given = mazes.size();
  lesson.selection = select_mazes(std::move(mazes), world);
  const std::size_t all = lesson.selection.mazes.size();
  if (all == 0) lesson.error = fmt::format("nothing to learn from: no maze with a route ({} given)", given);
  for (const NamedMaze& maze : lesson.selection.mazes) {
    if (hooks.stop != nullptr && hooks.stop->load()) break;
    lesson.counts.explore(maze.maze, world.traits().rules_in_steps.value_or(Rules()));
    ++lesson.done;
    if (hooks.finished) hooks.finished(all);
  }
  return lesson;
}

std::string file_of(const Lesson& lesson) {
  PriorProvenance provenance;
  provenance.version = version();
  for (const NamedMaze& maze : lesson.selection.mazes) provenance.mazes.push_back(maze.maze.size());
  provenance.fit = fit_of(lesson.counts);
  return write_prior(prior_of(lesson.counts), provenance);
}

std::string summary_of(const Lesson& lesson) { return words_of(lesson) + left_out_notes(lesson.selection, ""); }

}  // namespace labmouse
