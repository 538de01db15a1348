// labmouse robot: the turns, straights and search computed from the limits of a robot.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_arrays.hpp"
#include "labmouse/lab/robots/robot_data.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "robot_fit.hpp"

namespace labmouse::cli {
namespace {

struct RobotOptions {
  std::string robot = "classic";
  std::string svg;
  std::string arrays;
  std::string format = "table";
};

std::vector<std::string> names_of_turn_names() {
  std::vector<std::string> names;
  for (const TurnNames& each : all_turn_names()) names.emplace_back(each.name);
  return names;
}

std::string arrays_of(const FoundRobot& found, const std::string& name) {
  if (found.robot.fixed)
    throw UsageError(
        fmt::format("{}: error: the file has times of turns, not the limits from which their curves follow; --c needs "
                    "those",
                    shown(found.robot.name)));
  const auto names = all_turn_names();
  return robot_arrays(found.robot, found.model, *std::find_if(names.begin(), names.end(), [&](const TurnNames& each) {
                        return each.name == name;
                      }));
}

void show(const RobotOptions& options) {
  expect_outputs({{"--svg", options.svg, FileKind::picture}});
  const FoundRobot found = find_robot_or_refuse(options.robot);
  const bool json = options.format == "json";
  if ((options.arrays.empty() ? 0 : 1) + (options.svg.empty() ? 0 : 1) + (json ? 1 : 0) > 1)
    throw UsageError("error: --c prints arrays, --svg saves a picture and --format json prints JSON; choose one");
  if (!options.arrays.empty()) return print(arrays_of(found, options.arrays));
  if (json)
    return print(robot_data(found.robot, found.model).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  if (options.svg.empty()) return print(robot_table(found.robot, found.model));
  save(options.svg, draw_robot(found.robot, found.model));
}

void list_robots() {
  std::size_t width = 0;
  for (const BuiltinRobot& robot : builtin_robots()) width = std::max(width, robot.name.size());
  std::string text;
  for (const BuiltinRobot& robot : builtin_robots()) {
    const FoundRobot found = find_robot_or_refuse(std::string(robot.name));
    text += fmt::format("{:<{}}  {}\n", robot.name, width, robot_line(found.robot, found.model));
  }
  print(text);
}

}  // namespace

FoundRobot find_robot_or_refuse(const std::string& name) {
  FoundRobot found = find_robot(name);
  if (!found.errors.empty()) throw UsageError(fmt::format("{}", fmt::join(found.errors, "\n")));
  return found;
}

void add_robot_option(Command& command, std::string& robot) {
  command.add_option("--robot", robot, "Built-in robot, or a file whose name contains a slash or ends in .toml")
      ->type_name("ROBOT")
      ->capture_default_str();
}

void add_robot(Command& app, int& exit) {
  Command* command = app.add_subcommand("robot", "Show the robots of the world in seconds: their turns and times");
  command->require_subcommand();
  command->footer("Example: labmouse robot show classic");

  auto options = std::make_shared<RobotOptions>();
  Command* shown = command->add_subcommand("show", "Show what follows from the limits of a robot");
  shown->add_option("robot", options->robot, "Name of a built-in robot, or a file with a slash or .toml in its name")
      ->type_name("ROBOT")
      ->capture_default_str();
  shown->add_option("--svg", options->svg, "Save a picture of its turns instead of printing the table")
      ->type_name("FILE");
  shown
      ->add_option("--c", options->arrays,
                   "Print C arrays of turns and straights for firmware instead of the table; turns have plain names or "
                   "those of ukmars or kerikun11")
      ->type_name("NAMES")
      ->check(one_of(names_of_turn_names()));
  shown->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  shown->footer("Example: labmouse robot show half --svg half.svg\n         labmouse robot show ./my-mouse.toml");
  shown->callback([options, &exit] {
    show(*options);
    exit = exit_good;
  });

  add_robot_fit(*command);
  Command* listed = command->add_subcommand("list", "List the built-in robots");
  listed->footer("Example: labmouse robot list");
  listed->callback([&exit] {
    list_robots();
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
