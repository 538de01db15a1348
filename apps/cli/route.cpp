// labmouse route: the fastest route of a maze in seconds.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "command.hpp"
#include "labmouse/lab/pictures/drive_picture.hpp"
#include "labmouse/lab/robots/robot_family.hpp"
#include "labmouse/lab/routes/region_picture.hpp"
#include "labmouse/lab/routes/route_regions.hpp"
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
  std::string vary, along;
};

VariedNumber varied_number(const std::string& option, const std::string& text) {
  VariedNumberResult read = read_varied_number(text);
  if (!read.error.empty()) throw UsageError(fmt::format("error: {} {}: {}", option, text, read.error));
  return std::move(read.number);
}

/// Finds the regions in which one route stays the fastest, as one or two numbers of the robot vary.
int regions(const RouteOptions& options, const std::vector<NamedMaze>& mazes, const DriveModel& model) {
  if (mazes.size() != 1)
    throw UsageError(fmt::format("error: --vary looks at one maze, but {} are named", mazes.size()));
  if (const std::string why = route_report(mazes.front().maze, model).error; !why.empty())
    throw UsageError(fmt::format("{}: error: {}", mazes.front().name, why));
  const VariedNumber across = varied_number("--vary", options.vary);
  std::optional<VariedNumber> along;
  if (!options.along.empty()) along = varied_number("--and", options.along);
  if (along && along->key == across.key) throw UsageError("error: --vary and --and name the same number");
  const RegionOrder order = order_of(across, along);
  const FoundFamily family = find_robot_family(options.robot);
  if (!family.family) throw UsageError(family.error);
  const RouteRegions found = find_regions(mazes.front().maze, *family.family, order);
  if (found.routes.empty())
    throw UsageError(fmt::format("error: {}: no robot of this range has a route: {}", mazes.front().name,
                                 found.rows.front().regions.front().refusal));
  if (!options.svg.empty())
    save(options.svg,
         draw_regions(mazes.front().maze, found, order, title_of_regions(mazes.front().name, options.robot)));
  print(options.format == "json" ? json_of(found, order, mazes.front().name, options.robot)
                                 : table_of(found, order, mazes.front().name, options.robot));
  return exit_good;
}

int route(const RouteOptions& options) {
  expect_outputs({{"--svg", options.svg, FileKind::picture}});
  const FoundRobot robot = find_robot_or_refuse(options.robot);
  tell_remarks(robot.remarks);
  const DriveModel& model = robot.model;
  const std::vector<NamedMaze> mazes = find_mazes(options.mazes, options.places, {.closes_unseen = true}).mazes;
  if (!options.vary.empty()) return regions(options, mazes, model);
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
  command->add_option("--format", options->format, "What is printed")
      ->check(one_of({"table", "json"}))
      ->capture_default_str();
  command->add_option("--svg", options->svg, "Also save a picture of the route")->type_name("FILE");
  auto* vary = command
                   ->add_option("--vary", options->vary,
                                "Vary a number of the robot file and find the regions in which one route wins")
                   ->type_name("KEY=FROM:TO");
  command->add_option("--and", options->along, "Vary a second number, too")->type_name("KEY=FROM:TO")->needs(vary);
  command->footer("Example: labmouse route contest-01 --robot mm2021");
  command->callback([options, &exit] { exit = route(*options); });
}

}  // namespace labmouse::cli
