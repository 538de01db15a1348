// labmouse robot: what follows from the limits of a robot.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command.hpp"
#include "labmouse/lab/pictures/robot_picture.hpp"
#include "labmouse/lab/robots/builtin_robots.hpp"
#include "labmouse/lab/robots/fitted_robot.hpp"
#include "labmouse/lab/robots/robot_table.hpp"
#include "labmouse/lab/system/files.hpp"

namespace labmouse::cli {
namespace {

struct RobotOptions {
  std::string robot = "classic";
  std::string svg;
};

void show(const RobotOptions& options) {
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

struct FitOptions {
  std::string turns;
  std::string base = "classic";
  double cell = 0.0;
};

int fit(const FitOptions& options) {
  const FileContent file = read_file(options.turns);
  if (!file.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.turns, file.error));
  const TurnTable table = read_turn_table(file.content);
  std::string problems;
  for (const Problem& problem : table.problems)
    problems += (problems.empty() ? "" : "\n") + describe(options.turns, problem);
  if (!problems.empty()) throw UsageError(problems);
  const Robot base = find_robot_or_refuse(options.base).robot;
  const double known = options.cell > 0.0 ? options.cell : cell_of(table.turns);
  const FittedRobot fitted = fitted_robot(table.turns, base, known > 0.0 ? known : base.cell);
  if (!fitted.error.empty()) throw UsageError(fmt::format("{}: error: {}", options.turns, fitted.error));
  print(fitted.text);
  if (fitted.doubt.empty()) return exit_good;
  tell(fmt::format("{}: {}\n", options.turns, fitted.doubt));
  return exit_finding;
}

void add_fit(Command& command, int& exit) {
  auto options = std::make_shared<FitOptions>();
  Command* fitting = command.add_subcommand("fit", "Write a robot file from published or measured turns");
  fitting->add_option("--turns", options->turns, "Table of turns: columns turn, speed, ms, x, y, before, after")
      ->required()
      ->type_name("TABLE");
  fitting->add_option("--base", options->base, "Robot that all other numbers are taken from")
      ->type_name("ROBOT")
      ->capture_default_str();
  fitting
      ->add_option("--cell", options->cell,
                   "Side of a cell in mm; default: what S90 with its straights says, or that of the other robot")
      ->type_name("MM")
      ->check(in_range(20.0, 1000.0));
  fitting->footer("Example: labmouse robot fit --turns turns.txt --base kerise > my-mouse.toml");
  fitting->callback([options, &exit] { exit = fit(*options); });
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

  add_fit(*command, exit);
  command->add_subcommand("list", "List the built-in robots")->callback([&exit] {
    list();
    exit = exit_good;
  });
}

}  // namespace labmouse::cli
