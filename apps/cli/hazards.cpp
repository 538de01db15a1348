// labmouse hazards: what goes wrong in the physical world, and at what.
#include "labmouse/lab/hazards/hazards.hpp"

#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "contests.hpp"
#include "labmouse/contest/physical.hpp"
#include "labmouse/lab/robots/robot_files.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "labmouse/mouse/drive/fastest.hpp"

namespace labmouse::cli {
namespace {

struct HazardOptions {
  std::vector<std::string> mice;
  std::vector<std::string> mazes;
  Places places;
  std::string robot = "kerise", rules = "all-japan", noise = "1,2,3";
  std::string map = std::string(name_of(MapKind::first));
  double spread = field_spread, speed = 0.0;
  int runs = 1;
  std::uint64_t seed = 1;
  int jobs = 0;
  std::string format = "table";
};

int hazards(const HazardOptions& options) {
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  tell_remarks(robot.remarks);
  if (const std::string why = why_not_physical(robot.model); !why.empty())
    throw UsageError(fmt::format("error: {} cannot drive in the physical world: {}", shown(options.robot), why));
  DriveModel model = robot.model;
  share_route_tables(model);
  HazardOrder order;
  order.model = std::make_shared<DriveModel>(std::move(model));
  order.rules = find_rules_or_refuse(options.rules);
  order.conditions.noise.spread = options.spread;
  order.conditions.pilot.search_speed = options.speed;
  order.conditions.map = *map_kind_of(options.map);
  order.noises = noises_of(options.noise);
  order.runs = options.runs;
  order.seed = options.seed;
  order.jobs = options.jobs;
  const std::vector<Contestant> mice =
      find_contestants(options.mice.empty() ? std::vector<std::string>{"flood-return", "certify"} : options.mice);
  for (const Contestant& mouse : mice)
    if (!mouse.drive)
      throw UsageError(fmt::format("error: --mice: {} does not drive by decisions in seconds", shown(mouse.name)));
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places).mazes;
  const Interruptible interruptible;
  const auto tallies = measure_hazards(order, mice, mazes, &interruptible.stopped());
  print(options.format == "json" ? json_of(tallies, order, mice) : table_of(tallies));
  return interruptible.stopped() ? exit_interrupted() : exit_good;
}

}  // namespace

void add_hazards(Command& app, int& exit) {
  auto options = std::make_shared<HazardOptions>();
  Command* command = app.add_subcommand(
      "hazards", "Hold contests in the physical world and count at what mice stray, misread and crash");
  command->add_option("--mice", options->mice, "Mice, as race takes them; default: flood-return and certify")
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
  command->add_option("--noise", options->noise, "Factors of all noise, separated by commas: 1 as it was measured")
      ->type_name("LIST")
      ->capture_default_str();
  command
      ->add_option("--spread", options->spread,
                   "How far contests are apart: factor of what each draws of the mouse itself")
      ->check(in_range(0.0, 10.0))
      ->capture_default_str();
  command->add_option("--search-speed", options->speed, "Speed of a search in mm/s; 0: the robot's own")
      ->check(in_range(0.0, 20'000.0))
      ->capture_default_str();
  command->add_option("--map", options->map, "What mice do with a reading against their map: nothing, or weigh it")
      ->check(one_of({"first", "belief"}))
      ->capture_default_str();
  command->add_option("--runs", options->runs, "Contests of each mouse in each maze, under each noise")
      ->check(in_range(1, 1'000'000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed for all random choices")
      ->check(seed_number())
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "Number of threads; 0 uses all processors")
      ->check(in_range(0, 1024))
      ->capture_default_str();
  command->add_option("--format", options->format, "Output")->check(one_of({"table", "json"}))->capture_default_str();
  command->callback([options, &exit] { exit = hazards(*options); });
}

}  // namespace labmouse::cli
