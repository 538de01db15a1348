// labmouse sweep: one mouse at many values of one parameter, or of one number of its robot.
#include "labmouse/lab/studies/sweep.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "command.hpp"
#include "contests.hpp"
#include "external.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/worlds/robot_variants.hpp"

namespace labmouse::cli {
namespace {

struct SweepOptions {
  std::string mouse, vary, robot_number, svg, csv;
  std::string format = "table";
  Contests contests;
  ExternalOptions external_mice;
};

/// What is raced, before it is raced.
struct Planned {
  SweptValues swept;
  Entry entry;
  MazeCollection mazes;
};

/// The parameter of the mouse, or the number of the robot, with its values.
SweptValues swept_values_of(const SweepOptions& options) {
  if (options.vary.empty() == options.robot_number.empty())
    throw UsageError(options.vary.empty()
                         ? "error: '--vary' or '--robot-number' is missing: a parameter of the mouse or a number of "
                           "the robot, with its values"
                         : "error: --vary and --robot-number are two sweeps; give one of them");
  SweptValues swept = read_swept_values(options.vary.empty() ? options.robot_number : options.vary);
  if (!swept.error.empty()) throw UsageError("error: " + swept.error);
  return swept;
}

Planned planned(const SweepOptions& options) {
  SweptValues swept = swept_values_of(options);
  ExternalOptions external_mice = options.external_mice;
  Entry entry = options.contests.world.enter_one(
      options.vary.empty() ? find_contestants({options.mouse}, external_mice)
                           : mice_of(read_variants(options.mouse, swept.parameter, swept.values, external_mice)));
  if (options.vary.empty() && entry.mice.size() != 1)
    throw UsageError(fmt::format("error: '{}' names {} mice; name exactly one", options.mouse, entry.mice.size()));
  MazeCollection mazes = find_mazes_of(entry, options.contests);
  return {std::move(swept), std::move(entry), std::move(mazes)};
}

Sweep hold(const SweepOptions& options, const Planned& plan, const RaceOrder& order) {
  RobotVariants robots;
  if (options.vary.empty()) {
    robots = robot_variants(plan.entry, plan.swept.parameter, plan.swept.values);
    if (!robots.error.empty()) throw UsageError(robots.error);
    tell_remarks(robots.remarks);
  }
  Progress progress;
  const Interruptible interruptible;
  SweepHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  if (options.vary.empty()) return hold_robot_sweep(plan.entry.mice.front(), robots, plan.mazes.mazes, order, hooks);
  ExternalOptions external_mice = options.external_mice;
  external_mice.stop = &interruptible.stopped();
  return hold_sweep(options.mouse, plan.swept, plan.mazes.mazes, order, hooks, external_mice);
}

int sweep(const SweepOptions& options) {
  expect_outputs({{"--csv", options.csv, FileKind::sweep, true},
                  {"--svg", options.svg, FileKind::picture, true},
                  {"--store", options.contests.store_path}});
  const Planned plan = planned(options);
  const RaceOrder order = options.contests.order_in(plan.entry.world);
  const Sweep result = hold(options, plan, order);
  const bool table = options.format == "table";
  print(table ? table_of(result, colours()) : json_of(result));
  options.contests.finish_store(table);
  tell(freedom_note(plan.entry.mice));
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
  Command* command =
      app.add_subcommand("sweep", "Race one mouse at many values of one parameter, or of one number of its robot");
  command
      ->add_option("mouse", options->mouse,
                   "Mouse: name[:key=value]..., or an external mouse whose command has {NAME} in place of the value")
      ->required()
      ->type_name("MOUSE");
  command->add_option("--vary", options->vary, "Parameter and its values: a range with a step, or a list")
      ->type_name("NAME=LOW:HIGH:STEP|NAME=VALUE,VALUE,...");
  command
      ->add_option(
          "--robot-number", options->robot_number,
          "Key of the file of --robot and its values: races the mouse with a robot for each, and compares each "
          "with the first, maze by maze")
      ->type_name("KEY=LOW:HIGH:STEP|KEY=VALUE,VALUE,...");
  add_contests(*command, options->contests);
  add_racing_options(*command, options->external_mice);
  command->group(groups::output);
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  command->add_option("--csv", options->csv, "Save the numbers as CSV, one line per value")->type_name("FILE");
  command->add_option("--svg", options->svg, "Save a plot of the mean score against the value")->type_name("FILE");
  command->footer(
      "Example: labmouse sweep flood --vary stride=1:3:1 --mazes capstone-1 --svg strides.svg\n"
      "         labmouse sweep festina --world physical --robot-number straight.acceleration=3000:6000:1000");
  command->refer({groups::mazes, groups::world, groups::contests, groups::programs}, "labmouse race");
  command->callback([options, &exit] { exit = sweep(*options); });
}

}  // namespace labmouse::cli
