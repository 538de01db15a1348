// labmouse tune: better values for several parameters of a mouse at once.
#include "labmouse/lab/studies/tune.hpp"

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"

namespace labmouse::cli {
namespace {

struct TuneOptions {
  std::string mouse, parameters, log, svg;
  std::string objective = "score";
  Contests contests;
  TuneOrder order;
};

std::vector<ParameterRange> find_ranges(const TuneOptions& options) {
  mice_of(read_specs(options.mouse));
  RangesResult result = read_ranges(options.mouse, options.parameters);
  if (!result.error.empty()) throw UsageError("error: " + result.error);
  return std::move(result.ranges);
}

/// The mouse as given, and variants with one parameter at an end of its range. A world that accepts these accepts all
/// candidates.
std::vector<Contestant> corners(const std::string& mouse, const std::vector<ParameterRange>& ranges) {
  std::vector<Contestant> mice = mice_of(read_specs(mouse));
  for (const ParameterRange& range : ranges)
    for (const double end : {range.low, range.high}) {
      const Setting setting = {std::string(range.parameter.name), written_value(range, end)};
      mice.push_back(read_variant(mouse, {&setting, 1}).contestants.front());
    }
  return mice;
}

/// Runs the search and writes its log. A write error ends the search early and is stored in `failed_write`.
Tune hold(const TuneOptions& options, const std::vector<ParameterRange>& ranges, const std::vector<NamedMaze>& mazes,
          const RaceOrder& race, std::string& failed_write) {
  Progress progress;
  Interruptible interruptible;
  TuneHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  hooks.generation = [&](const Tune& tune) {
    if (options.log.empty() || is_stream(options.log) || tune.evaluations.empty() || !failed_write.empty()) return;
    if (const auto error = write_file(options.log, csv_of(tune)); !error.empty()) {
      failed_write = options.log + ": error: " + error;
      interruptible.stop();
    }
  };
  TuneOrder order = options.order;
  order.race = race;
  order.objective = options.objective == "ratio" ? Objective::ratio : Objective::score;
  return hold_tune(options.mouse, ranges, mazes, order, hooks);
}

int tune(const TuneOptions& options) {
  expect_outputs({{"--log", options.log, FileKind::tune},
                  {"--svg", options.svg, FileKind::picture, true},
                  {"--store", options.contests.store_path}});
  const std::vector<ParameterRange> ranges = find_ranges(options);
  Entry entry = options.contests.world.enter_one(corners(options.mouse, ranges));
  const MazeCollection mazes = find_mazes_of(entry, options.contests);
  const RaceOrder order = options.contests.order_in(entry.world);
  std::string failed_write;
  const Tune result = hold(options, ranges, mazes.mazes, order, failed_write);
  if (!result.error.empty()) throw UsageError("error: " + result.error);
  print(table_of(result, colours()));
  // Reports on standard error, because the last line of the output is a SPEC for programs.
  options.contests.finish_store(false);
  if (!failed_write.empty()) throw UsageError(failed_write);
  const bool any = !result.evaluations.empty();
  if (any && is_stream(options.log)) save(options.log, csv_of(result));
  if (any && !options.svg.empty()) (result.stopped ? save_partial : save)(options.svg, picture_of(result));
  return result.stopped ? exit_interrupted() : exit_good;
}

}  // namespace

void add_tune(Command& app, int& exit) {
  auto options = std::make_shared<TuneOptions>();
  Command* command = app.add_subcommand("tune", "Search for better values of several parameters of a mouse");
  command->add_option("mouse", options->mouse, "Mouse: name[:key=value]...; the search starts from its values")
      ->required()
      ->type_name("MOUSE");
  command
      ->add_option("--params", options->parameters,
                   "Parameters to change, within their whole ranges or the ranges given")
      ->required()
      ->type_name("NAME[=LOW:HIGH],...");
  command
      ->add_option("--evaluations", options->order.evaluations,
                   "Total number of candidates, including the mouse as given")
      ->required()
      ->check(in_range(1, 1'000'000));
  command
      ->add_option("--population", options->order.population,
                   "Candidates per generation; default: 4 + 3 ln(parameters)")
      ->check(in_range(4, 10'000));
  command->add_option("--sigma", options->order.step, "Initial step of each parameter, as a share of its range")
      ->check(finite_number())
      ->check(in_range(0.0001, 1.0))
      ->capture_default_str();
  command->add_option("--objective", options->objective, "Minimise the mean score, or the mean of score / bound")
      ->check(one_of({"score", "ratio"}))
      ->capture_default_str();
  add_contests(*command, options->contests);
  command->group(groups::output);
  command->add_option("--log", options->log, "Save every evaluation as CSV, updated after each generation")
      ->type_name("FILE");
  command->add_option("--svg", options->svg, "Save a plot of the generations")->type_name("FILE");
  command->footer(
      "Example: labmouse tune visit-counter --params random_share,coverage=0.2:0.9 --mazes capstone-1 "
      "--evaluations 20 --log tune.csv");
  command->refer({groups::mazes, groups::world, groups::contests}, "labmouse race");
  command->callback([options, &exit] { exit = tune(*options); });
}

}  // namespace labmouse::cli
