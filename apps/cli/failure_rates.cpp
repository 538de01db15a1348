// labmouse failure-rates: measures how often manoeuvres and wall readings fail in the physical world.
#include "labmouse/lab/failure_rates/failure_rates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drive/drive_entries.hpp"
#include "labmouse/lab/drive/fidelity.hpp"
#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/text/former_names.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse::cli {
namespace {

struct FailureOptions {
  const Command* command = nullptr;
  std::vector<std::string> mice;
  std::vector<std::string> mazes;
  Places places;
  std::string robot = "kerise", rules = "all-japan", variation = "0.5,1,1.2", pace = "1";
  std::string map = std::string(name_of(MapKind::first));
  PhysicalConditions conditions;
  int runs = 1;
  std::uint64_t seed = 1;
  int jobs = 0;
  std::string format = "table";
  std::string save, check;
  double within = 3.0, interval_within = 5.0;
};

/// Runs all contests in the physical world and in the failure model. Returns exit_finding if the shares of finished
/// contests differ by more than allowed.
int check_rates(const FailureOptions& options, FailureOrder order, const std::vector<Contestant>& mice,
                const std::vector<NamedMaze>& mazes) {
  for (const std::string name : {"--pace", "--noise", "--search-speed", "--save", "--format"})
    if (options.command->count(name) > 0) throw UsageError(fmt::format("error: {} cannot be used with --check", name));
  const FoundRates failure_rates = find_rates(options.check);
  if (!failure_rates.file) throw UsageError(failure_rates.error);
  const double most = *std::max_element(order.variations.begin(), order.variations.end());
  if (const std::string why = why_not_failures(*order.model, most, *failure_rates.file); !why.empty())
    throw UsageError("error: " + why);
  const FidelityBars bars = {options.within / 100.0, options.interval_within / 100.0};
  const Interruptible interruptible;
  const auto all = compare_worlds(order, *failure_rates.file, mice, mazes, &interruptible.stopped());
  print(table_of(all, bars));
  const std::size_t variations = order.variations.size();
  if (all.size() < mice.size() * variations) {
    print(fmt::format("\nStopped early: {} of {} variations compared.\n", all.size() / mice.size(), variations));
    return exit_interrupted();
  }
  const bool good = std::all_of(all.begin(), all.end(), [&](const Fidelity& each) { return is_faithful(each, bars); });
  return good ? exit_good : exit_finding;
}

MeasuredRates measure(const FailureOrder& order, const std::vector<Contestant>& mice,
                      const std::vector<NamedMaze>& mazes) {
  Progress progress;
  const Interruptible interruptible;
  FailureHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  return measure_rates(order, mice, mazes, hooks);
}

int failure_rates(const FailureOptions& options) {
  expect_outputs({{"--save", options.save, FileKind::failure_rates, true}});
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  tell_remarks(robot.remarks);
  if (const std::string why = why_not_physical(robot.model); !why.empty())
    throw UsageError(fmt::format("error: {} cannot drive in the physical world: {}", shown(options.robot), why));
  DriveModel model = robot.model;
  share_route_tables(model);
  FailureOrder order;
  order.model = std::make_shared<DriveModel>(std::move(model));
  order.rules = find_rules_or_refuse(options.rules);
  if (order.rules.counts != Counted::run)
    throw UsageError(fmt::format("error: --rules: {} has counts = \"{}\"; choose rules that count runs",
                                 shown(options.rules), name_of(order.rules.counts)));
  order.conditions = options.conditions;
  order.conditions.map = *map_kind_of(today_value(options.map));
  order.variations = numbers_of(variation_row.setting, options.variation);
  order.paces = numbers_of(pace_row.setting, options.pace);
  order.runs = options.runs;
  order.seed = options.seed;
  order.jobs = options.jobs;
  const std::vector<Contestant> mice =
      find_contestants(options.mice.empty() ? std::vector<std::string>{"flood-return", "certify"} : options.mice);
  for (const Contestant& mouse : mice)
    if (mouse.external)
      throw UsageError(fmt::format(
          "error: --mice: '{}' is an external mouse; failure rates are counted with built-in mice: remove it",
          shown(mouse.name)));
  if (const std::string why = refuse_to_drive(mice, Driving::with_errors); !why.empty())
    throw UsageError("error: --mice: " + why);
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places).mazes;
  if (!options.check.empty()) return check_rates(options, std::move(order), mice, mazes);
  const MeasuredRates measured = measure(order, mice, mazes);
  const bool any = std::any_of(measured.tallies.begin(), measured.tallies.end(),
                               [](const FailureTally& tally) { return tally.all().contests > 0; });
  if (any && !options.save.empty())
    (measured.stopped ? save_partial : save)(options.save, write_rates(measured, order, mice, mazes.size()));
  print(options.format == "json" ? json_of(measured, order, mice, mazes.size()) : table_of(measured, order));
  return measured.stopped ? exit_interrupted() : exit_good;
}

}  // namespace

void add_failure_rates(Command& app, int& exit) {
  auto options = std::make_shared<FailureOptions>();
  Command* command = app.add_subcommand(
      "failure-rates",
      "Measure failure rates in the physical world: crashes, localization errors and wrong wall readings");
  command->add_option("--mice", options->mice, "Mice, as --mice of `labmouse race`; default: flood-return and certify")
      ->type_name("SPEC")
      ->expected(1, 1 << 20)
      ->take_all();
  command
      ->add_option("--mazes", options->mazes,
                   "Maze files, folders, patterns or built-in mazes; default: all built-in mazes")
      ->type_name("PATH")
      ->expected(1, 1 << 20)
      ->take_all();
  add_places(*command, options->places);
  command
      ->add_option("--robot", options->robot, "Built-in robot, or a file whose name contains a slash or ends in .toml")
      ->type_name("ROBOT")
      ->capture_default_str();
  command
      ->add_option("--rules", options->rules,
                   "Built-in rules in seconds, or a file whose name contains a slash or ends in .toml")
      ->type_name("RULES")
      ->capture_default_str();
  command
      ->add_option("--variation", options->variation,
                   "Scales of the variation, separated by commas, or their names: as --variation of `labmouse race`")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option(
          "--pace", options->pace,
          fmt::format("Shares of the robot's usual speed, separated by commas ({})", range_of(pace_row.setting)))
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--noise", options->conditions.errors.noise,
                   "Scale of the noise of each moment: 1 as measured, 0 none")
      ->check(in_range(noise_row.setting.low, noise_row.setting.high))
      ->capture_default_str();
  command
      ->add_option("--search-speed", options->conditions.controller.search_speed,
                   std::string(search_speed_row.setting.meaning))
      ->check(setting_value(search_speed_row.setting))
      ->capture_default_str();
  command->add_option("--map", options->map, "How contradicting wall readings are handled: as --map of `labmouse race`")
      ->check(setting_value(map_row.setting))
      ->capture_default_str();
  command->add_option("--runs", options->runs, "Contests of each mouse in each maze, under each variation")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed for all random choices")
      ->check(seed_number())
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  command
      ->add_option("--save", options->save,
                   "Save the rates in a file, for `labmouse race --world failures --failure-rates FILE`")
      ->type_name("FILE");
  command
      ->add_option(
          "--check", options->check,
          "Instead run the same contests in the failure model with these rates, and exit with 1 if the share of "
          "finished ones differs")
      ->type_name("RATES");
  command->add_option("--within", options->within, "With --check: points of 100 by which shares may differ")
      ->check(in_range(0.0, 100.0))
      ->capture_default_str();
  command
      ->add_option("--interval-within", options->interval_within,
                   "With --check: points of 100 within which the difference's 95 % interval has to lie")
      ->check(in_range(0.0, 100.0))
      ->capture_default_str();
  command->footer(
      "Example: labmouse failure-rates --mice ariadne --mazes contest-01 --variation 0.5,1 --save my-rates.json\n"
      "         labmouse failure-rates --mice ariadne --mazes contest-01 --check ./my-rates.json");
  options->command = command;
  command->callback([options, &exit] { exit = failure_rates(*options); });
}

}  // namespace labmouse::cli
