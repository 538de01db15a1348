// labmouse learn: learns a prior of unseen walls from mazes.
#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/lab/studies/prior_lesson.hpp"
#include "labmouse/lab/worlds/worlds.hpp"

namespace labmouse::cli {
namespace {

struct LearnOptions {
  std::vector<std::string> mazes;
  Places places;
  std::string out;
};

Lesson hold(std::vector<NamedMaze> mazes) {
  Progress progress;
  const Interruptible interruptible;
  LessonHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  return hold_lesson(std::move(mazes), *first_world(), hooks);
}

int learn(const LearnOptions& options) {
  expect_outputs({{"--out", options.out, FileKind::prior}});
  MazeCollection mazes = find_mazes(options.mazes, options.places);
  const Lesson lesson = hold(std::move(mazes.mazes));
  if (!lesson.error.empty()) throw UsageError("error: " + lesson.error);
  // An incomplete prior does not replace an earlier file.
  const bool stopped = lesson.done < lesson.selection.mazes.size();
  if (!stopped) save(options.out, file_of(lesson));
  print(summary_of(lesson));
  return stopped ? exit_interrupted() : exit_good;
}

}  // namespace

void add_learn(Command& app, int& exit) {
  auto options = std::make_shared<LearnOptions>();
  Command* command =
      app.add_subcommand("learn", "Learn from mazes which walls to expect, for mice with the parameter 'prior'");
  command
      ->add_option("mazes", options->mazes,
                   "Maze files, folders, patterns or built-in mazes; default: all built-in mazes")
      ->type_name("MAZE");
  add_places(*command, options->places);
  command->add_option("-o,--out", options->out, "File to write; a mouse reads it as in ariadne:prior=FILE")
      ->required()
      ->type_name("FILE");
  command->footer(
      "Example: labmouse learn contest-01 contest-02 -o my.prior && labmouse race --mice ariadne:prior=./my.prior");
  command->callback([options, &exit] { exit = learn(*options); });
}

}  // namespace labmouse::cli
