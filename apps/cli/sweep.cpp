// labmouse sweep: one mouse at many values of one parameter.
#include "labmouse/lab/studies/sweep.hpp"

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/lab/mice/specs.hpp"

namespace labmouse::cli {
namespace {

struct SweepOptions {
  std::string mouse, vary, svg, csv;
  Contests contests;
  ExternalOptions external_mice;
};

Sweep hold(const SweepOptions& options, const Variation& variation, const std::vector<NamedMaze>& mazes,
           const RaceOrder& order) {
  Progress progress;
  const Interruptible interruptible;
  SweepHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  ExternalOptions external_mice = options.external_mice;
  external_mice.stop = &interruptible.stopped();
  return hold_sweep(options.mouse, variation, mazes, order, hooks, external_mice);
}

int sweep(const SweepOptions& options) {
  expect_outputs(
      {{"--csv", options.csv}, {"--svg", options.svg}, {"--store", options.contests.store_path, Output::Kind::other}});
  const Variation variation = read_variation(options.vary);
  if (!variation.error.empty()) throw UsageError("error: " + variation.error);
  Entry entry = options.contests.world.enter_one(
      mice_of(read_variants(options.mouse, variation.parameter, variation.values, options.external_mice)));
  const MazeCollection mazes = find_mazes_of(entry, options.contests);
  const RaceOrder order = options.contests.order_in(entry.world);
  const Sweep result = hold(options, variation, mazes.mazes, order);
  print(table_of(result, colours()));
  options.contests.finish_store(true);
  const bool stopped = result.points.size() < result.values, any = !result.points.empty();
  const auto save_all = stopped ? save_partial : save;
  if (any && !options.csv.empty()) save_all(options.csv, csv_of(result));
  if (any && !options.svg.empty()) save_all(options.svg, picture_of(result));
  if (stopped) return exit_interrupted();
  tell(result.never_started);
  return result.never_started.empty() ? exit_good : exit_finding;
}

}  // namespace

void add_sweep(Command& app, int& exit) {
  auto options = std::make_shared<SweepOptions>();
  Command* command = app.add_subcommand("sweep", "Race one mouse at many values of one parameter");
  command
      ->add_option("mouse", options->mouse,
                   "Mouse: name[:key=value]..., or an external mouse whose command has {NAME} in place of the value")
      ->required()
      ->type_name("MOUSE");
  command->add_option("--vary", options->vary, "Parameter and its values: a range with a step, or a list")
      ->required()
      ->type_name("NAME=LOW:HIGH:STEP|NAME=VALUE,VALUE,...");
  add_contests(*command, options->contests);
  add_racing_options(*command, options->external_mice);
  command->group(groups::output);
  command->add_option("--csv", options->csv, "Save the numbers as CSV, one line per value")->type_name("FILE");
  command->add_option("--svg", options->svg, "Save a plot of the mean score against the value")->type_name("FILE");
  command->footer("Example: labmouse sweep flood --vary stride=1:3:1 --mazes capstone-1 --svg strides.svg");
  command->refer({groups::mazes, groups::world, groups::contests, groups::programs}, "labmouse race");
  command->callback([options, &exit] { exit = sweep(*options); });
}

}  // namespace labmouse::cli
