// labmouse route: the fastest route of a maze in seconds.
#include <fmt/format.h>

#include <memory>

#include "command.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/routes/route_report.hpp"
#include "labmouse/lab/system/file_names.hpp"

namespace labmouse::cli {
namespace {

struct RouteOptions {
  std::vector<std::string> mazes;
  Places places;
  std::string robot = "classic";
  std::string format = "table";
  std::string svg;
};

int route(const RouteOptions& options) {
  expect_outputs({{"--svg", options.svg}});
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  tell_remarks(robot.remarks);
  const DriveModel& model = robot.model;
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places).mazes;
  std::vector<RouteReport> reports;
  const RouteReporter reporter(model);
  for (const NamedMaze& maze : mazes) reports.push_back(reporter.report(maze.maze));
  const bool one = mazes.size() == 1;
  if (one && !reports.front().error.empty())
    throw UsageError(fmt::format("{}: error: {}", mazes.front().name, reports.front().error));
  if (!options.svg.empty()) {
    if (!one) throw UsageError(fmt::format("error: --svg can draw only one maze, but {} are named", mazes.size()));
    const DriveRoute& drawn = reports.front().route;
    const std::string title =
        fmt::format("{}: {}, {:.3f} s", stem_of(mazes.front().name), model.robot.name, drawn.time / 1e6);
    save(options.svg, draw_route(mazes.front().maze, drawn, model, title));
  }
  if (options.format == "json")
    print(json_of(reports, mazes, model));
  else
    print(one ? table_of(reports.front(), mazes.front(), model) : summary_of(reports, mazes, model));
  return exit_good;
}

}  // namespace

void add_route(Command& app, int& exit) {
  auto options = std::make_shared<RouteOptions>();
  Command* command =
      app.add_subcommand("route", "Find the fastest route through a maze in seconds, with curves and diagonals");
  command
      ->add_option("mazes", options->mazes,
                   "Maze file or built-in maze; for several, or for folders and patterns, one line per maze")
      ->type_name("MAZE")
      ->required();
  add_places(*command, options->places);
  add_robot_option(*command, options->robot);
  command->add_option("--format", options->format, "Output")->check(one_of({"table", "json"}))->capture_default_str();
  command->add_option("--svg", options->svg, "Also save a picture of the route")->type_name("FILE");
  command->footer("Example: labmouse route contest-01 --robot mm2021");
  command->callback([options, &exit] { exit = route(*options); });
}

}  // namespace labmouse::cli
