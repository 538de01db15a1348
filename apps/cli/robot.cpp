// labmouse robot: the turns, straights and search computed from the limits of a robot.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "robot_fit.hpp"

namespace labmouse::cli {
namespace {

struct RobotOptions {
  std::string robot = "classic";
  std::string svg;
};

void show(const RobotOptions& options) {
  expect_outputs({{"the robot", options.robot, Output::Kind::input}, {"--svg", options.svg}});
  const FoundRobot found = find_robot_or_refuse(options.robot);
  if (options.svg.empty()) return print(robot_table(found.robot, found.model));
  save(options.svg, draw_robot(found.robot, found.model));
}

void list() {
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
  shown->footer("Example: labmouse robot show half --svg half.svg\n         labmouse robot show ./my-mouse.toml");
  shown->callback([options, &exit] {
    show(*options);
    exit = exit_good;
  });

  add_robot_fit(*command);
  Command* listed = command->add_subcommand("list", "List the built-in robots");
  listed->footer("Example: labmouse robot list");
  listed->callback([&exit] {
    list();
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
