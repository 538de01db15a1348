// labmouse drive: tests a robot's controller on known routes.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/drives/drive_log.hpp"
#include "labmouse/lab/drives/known_drives.hpp"
#include "labmouse/lab/failure_rates/physical_settings.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse::cli {
namespace {

struct DriveOptions {
  std::vector<std::string> mazes;
  Places places;
  std::string robot = "kerise";
  std::string noise = "1", variation = "1";
  PhysicalConditions conditions;
  bool fast = false, causes = false, corrections = false;
  int runs = 20;
  std::uint64_t seed = 1;
  int jobs = 0;
  std::string format = "table";
  std::string log;
};

/// The cases that are compared: the scales of noise and variation; with --causes or --corrections, for each of them the
/// causes of errors or the corrections of the estimator.
std::vector<DriveCase> cases_of(const DriveOptions& options) {
  if (options.causes && options.corrections)
    throw UsageError("error: --causes and --corrections are two comparisons; ask for one of them");
  if (options.fast && options.corrections)
    throw UsageError("error: --corrections compares drives by the moves of a search; leave --fast out");
  std::vector<DriveCase> cases;
  const std::vector<double> noises = numbers_of(noise_row.setting, options.noise),
                            variations = numbers_of(variation_row.setting, options.variation);
  const bool several = noises.size() * variations.size() > 1;
  for (const double noise : noises) {
    for (const double variation : variations) {
      PhysicalConditions conditions = options.conditions;
      conditions.errors.noise = noise;
      conditions.errors.variation = variation;
      const std::string name = fmt::format("noise {:g}, variation {:g}", noise, variation);
      std::vector<DriveCase> parts = options.causes        ? cases_by_cause(conditions)
                                     : options.corrections ? cases_by_correction(conditions)
                                                           : std::vector<DriveCase>{{"", conditions}};
      for (DriveCase& part : parts) {
        part.name = part.name.empty() ? name : several ? name + " " + part.name : part.name;
        cases.push_back(std::move(part));
      }
    }
  }
  return cases;
}

std::vector<DriveTally> drive_all(const DriveOrder& order, const std::vector<NamedMaze>& mazes,
                                  const std::vector<DriveCase>& cases) {
  Progress progress;
  const Interruptible interruptible;
  DriveHooks hooks;
  hooks.stop = &interruptible.stopped();
  hooks.finished = [&](std::size_t all) { progress.advance(all); };
  return drive_known_ways(order, mazes, cases, hooks);
}

int drive(const DriveOptions& options) {
  expect_outputs({{"--log", options.log, FileKind::log}});
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  tell_remarks(robot.remarks);
  if (const std::string why = why_not_physical(robot.model); !why.empty())
    throw UsageError(fmt::format("error: {} cannot drive in the physical world: {}", shown(options.robot), why));
  DriveModel model = robot.model;
  share_route_tables(model);
  DriveOrder order;
  order.model = std::make_shared<DriveModel>(std::move(model));
  order.way = options.fast ? KnownWay::fast : KnownWay::search;
  order.runs = options.runs;
  order.seed = options.seed;
  order.jobs = options.jobs;
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places).mazes;
  const std::vector<DriveCase> cases = cases_of(options);
  if (!options.log.empty() && (mazes.size() != 1 || cases.size() != 1 || options.runs != 1))
    throw UsageError("error: --log takes one drive; name one maze with --mazes, and add --runs 1");
  std::vector<LoggedTick> log;
  if (!options.log.empty()) order.log = &log;
  const std::vector<DriveTally> tallies = drive_all(order, mazes, cases);
  if (!log.empty()) {
    const DriveModel& driven = *order.model;
    save(options.log, log_text(log, Field(mazes.front().maze, driven.tables.cell), *driven.robot.hardware));
  }
  print(options.format == "json" ? json_of(tallies, order) : table_of(tallies, order));
  return is_stopped(tallies) ? exit_interrupted() : exit_good;
}

}  // namespace

void add_drive(Command& app, int& exit) {
  auto options = std::make_shared<DriveOptions>();
  Command* command = app.add_subcommand(
      "drive", "Test the controller on known routes: rates of crashes, tracking errors and wrong wall readings");
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
  command->add_option("--noise", options->noise, "Scales of the noise, separated by commas: 1 as measured, 0 none")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--variation", options->variation,
                   "Scales of the variation, separated by commas, or their names: as --variation of `labmouse race`")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--search-speed", options->conditions.controller.search_speed,
                   "Speed of the search moves in mm/s; 0: the robot's own")
      ->check(setting_value(search_speed_row.setting))
      ->capture_default_str();
  command->add_flag("--fast", options->fast, "Drive the fastest route instead of the moves of a search run");
  command->add_flag("--causes", options->causes, "Compare causes of errors: a row for each with the other causes off");
  command->add_flag("--corrections", options->corrections,
                    "Compare corrections of the position by walls: all, some and none");
  command->add_option("--runs", options->runs, "Drives in each maze")
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
  command->add_option("--log", options->log, "Save the log of one drive as CSV; takes one maze and --runs 1")
      ->type_name("FILE");
  command->footer(
      "Example: labmouse drive --mazes contest-01 --variation lab,contest,bad-day --runs 5\n"
      "         labmouse drive --mazes contest-01 --fast --runs 1 --log run.csv");
  command->callback([options, &exit] { exit = drive(*options); });
}

}  // namespace labmouse::cli
